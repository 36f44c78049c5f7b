#include "inspect/FilmPage.h"

#include "inspection/FilmWatchFiles.h"
#include "look/Icons.h"
#include "panels/PicturePanel.h"

#include <QDate>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMimeData>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr double longestWatch = 1e6; // s
constexpr int mapHeight = 900;       // pixels
constexpr double mapPixelsPerMillimetre = 5;
constexpr int rows = 4; // of photos that are seen at once

} // namespace

FilmPage::FilmPage(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 2)), begin_(new QDoubleSpinBox),
      water_(new QDoubleSpinBox), lot_(new QLineEdit), words_(new QLabel),
      map_(new PicturePanel(tr("Unevenness of the film"),
                            tr("Where the film has grown more and less is shown here."))) {
    setAcceptDrops(true);
    table_->setObjectName(QStringLiteral("filmPhotos"));
    table_->setAccessibleName(tr("Photos of the film"));
    table_->setHorizontalHeaderLabels({tr("Photo"), tr("Seconds since it was laid")});
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setMaximumHeight(table_->horizontalHeader()->sizeHint().height() +
                             rows * table_->verticalHeader()->defaultSectionSize() + 6);
    begin_->setObjectName(QStringLiteral("dipBegins"));
    begin_->setRange(0, longestWatch);
    begin_->setSuffix(tr(" s"));
    water_->setObjectName(QStringLiteral("waterTemperature"));
    water_->setRange(-1, 100);
    water_->setValue(-1);
    water_->setSpecialValueText(tr("not measured"));
    water_->setSuffix(tr(" °C"));
    words_->setObjectName(QStringLiteral("filmWords"));
    words_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setText(tr("Add photos of the film's chessboard floating on the water with the card "
                       "beside it, or drop them here. The guide says how they are made."));
    auto* form = new QFormLayout;
    form->addRow(tr("Dip begins after"), begin_);
    form->addRow(tr("Lot"), lot_);
    form->addRow(tr("Water"), water_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(table_);
    layout->addLayout(form);
    layout->addWidget(makeButtons());
    layout->addWidget(words_);
    layout->addWidget(map_, 1);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &FilmPage::enable);
    enable();
}

QWidget* FilmPage::makeButtons() {
    auto* bar = new QWidget;
    auto* column = new QVBoxLayout(bar);
    column->setContentsMargins(0, 0, 0, 0);
    auto* add = new QPushButton(icon(QStringLiteral("add")), tr("Add &Photos…"));
    add->setObjectName(QStringLiteral("addFilmPhotos"));
    remove_ = new QPushButton(tr("&Remove"));
    measure_ = new QPushButton(tr("&Measure"));
    measure_->setObjectName(QStringLiteral("measureFilm"));
    save_ = new QPushButton(tr("&Save to Profile…"));
    save_->setObjectName(QStringLiteral("saveFilmProfile"));
    export_ = new QPushButton(tr("&Export…"));
    export_->setObjectName(QStringLiteral("exportFilm"));
    const std::vector<QList<QPushButton*>> lines{{add, remove_, measure_}, {save_, export_}};
    for (const QList<QPushButton*>& line : lines) {
        auto* row = new QHBoxLayout;
        for (QPushButton* button : line) {
            row->addWidget(button);
        }
        row->addStretch();
        column->addLayout(row);
    }
    connect(add, &QPushButton::clicked, this, [this] {
        addPhotos(QFileDialog::getOpenFileNames(
            this, tr("Photos of the Film"), {},
            tr("Photos (%1)").arg(QStringLiteral("*.jpg *.jpeg *.png *.tif *.tiff *.bmp *.webp"))));
    });
    connect(remove_, &QPushButton::clicked, this, &FilmPage::removeChosen);
    connect(measure_, &QPushButton::clicked, this, &FilmPage::measureAsked);
    connect(save_, &QPushButton::clicked, this, &FilmPage::saveAsked);
    connect(export_, &QPushButton::clicked, this, &FilmPage::exportAsked);
    return bar;
}

void FilmPage::addPhotos(const QStringList& files) {
    for (const QString& file : files) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        auto* name = new QTableWidgetItem(QFileInfo(file).fileName());
        name->setData(Qt::UserRole, file);
        name->setToolTip(file);
        name->setFlags(name->flags() & ~Qt::ItemIsEditable);
        table_->setItem(row, 0, name);
        auto* seconds = new QDoubleSpinBox;
        seconds->setAccessibleName(tr("Seconds since the film was laid on the water"));
        seconds->setRange(-1, longestWatch);
        seconds->setValue(-1);
        seconds->setSpecialValueText(tr("when the dip begins"));
        table_->setCellWidget(row, 1, seconds);
    }
    enable();
}

void FilmPage::removeChosen() {
    const QList<QTableWidgetItem*> chosen = table_->selectedItems();
    QList<int> lines;
    for (const QTableWidgetItem* item : chosen) {
        lines << item->row();
    }
    std::sort(lines.rbegin(), lines.rend());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    for (const int row : lines) {
        table_->removeRow(row);
    }
    enable();
}

std::vector<FilmPhoto> FilmPage::photos() const {
    std::vector<FilmPhoto> photos;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const double seconds = qobject_cast<QDoubleSpinBox*>(table_->cellWidget(row, 1))->value();
        photos.push_back({table_->item(row, 0)->data(Qt::UserRole).toString(),
                          seconds < 0 ? std::nullopt : std::optional(seconds)});
    }
    return photos;
}

double FilmPage::begin() const {
    return begin_->value();
}

void FilmPage::setBegin(double seconds) {
    begin_->setValue(seconds);
}

WatchNotes FilmPage::notes() const {
    WatchNotes notes;
    notes.date = QDate::currentDate().toString(Qt::ISODate);
    notes.lot = lot_->text();
    if (water_->value() >= 0) {
        notes.waterTemperature = water_->value();
    }
    return notes;
}

void FilmPage::setMeasured(std::shared_ptr<const FilmWatch> watch) {
    watch_ = std::move(watch);
    if (watch_) {
        words_->setText(watchSentences(*watch_).join(u'\n'));
        const QImage map = unevennessMap(watch_->photos.back(), mapHeight);
        map_->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
    }
    enable();
}

void FilmPage::setBusy(bool busy) {
    busy_ = busy;
    enable();
}

void FilmPage::enable() {
    remove_->setEnabled(!table_->selectedItems().isEmpty() && !busy_);
    measure_->setEnabled(table_->rowCount() > 0 && !busy_);
    save_->setEnabled(watch_ && !busy_);
    export_->setEnabled(watch_ && !busy_);
}

void FilmPage::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void FilmPage::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    event->acceptProposedAction();
    addPhotos(files);
}

} // namespace dipwright
