#include "workbench/inspection/FilmPage.h"

#include "base/NumberText.h"
#include "import/trusted/ReadPhotos.h"
#include "inspection/FilmWatchFiles.h"
#include "workbench/widgets/DroppedFiles.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QSet>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace dipwright {

namespace {

constexpr int mapHeight = 900; // pixels
constexpr double mapPixelsPerMillimetre = 5;
constexpr int rows = 3; // photos visible without scrolling
constexpr int leastPicture = 220;
constexpr double none = -1; // stands for "no value" in fields from 0
constexpr double unknownLens = -1.0001;

// Returns nullopt below `least`, where the box shows its special text.
std::optional<double> valueOf(const NumberBox& box, double least = 0) {
    return box.value() < least ? std::nullopt : std::optional(box.value());
}

QWidget* side(NumberBox* first, NumberBox* second) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(first, 1);
    row->addWidget(second, 1);
    return both;
}

QWidget* inARow(const QList<QPushButton*>& buttons) {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    for (QPushButton* button : buttons) {
        row->addWidget(button);
    }
    row->addStretch();
    return bar;
}

QString hintText() {
    return FilmPage::tr(
        "Print the two pages, then add photos of the film's chessboard on the water with "
        "the card beside it, or drop them here. The guide explains how to take "
        "them.");
}

} // namespace

FilmPage::FilmPage(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 2)), lot_(new QLineEdit), words_(new QLabel),
      photoWords_(new QLabel), pictures_(new QTabWidget),
      boards_(new PicturePanel(tr("Photo of the film"),
                               tr("Corners found in the photo are shown here."))),
      map_(new PicturePanel(
          tr("Unevenness of the film"),
          tr("The places where the film has grown more or less than on average are shown here."))) {
    setAcceptDrops(true);
    table_->setObjectName(QStringLiteral("filmPhotos"));
    table_->setAccessibleName(tr("Photos of the film"));
    table_->setHorizontalHeaderLabels({tr("Photo"), tr("Seconds on the water")});
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    const int height = table_->horizontalHeader()->sizeHint().height() +
                       rows * table_->verticalHeader()->defaultSectionSize() + 6;
    table_->setFixedHeight(height);
    words_->setObjectName(QStringLiteral("filmWords"));
    words_->setWordWrap(true);
    photoWords_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    pictures_->setObjectName(QStringLiteral("filmPictures"));
    pictures_->setDocumentMode(true);
    pictures_->addTab(boards_, tr("Corners"));
    pictures_->addTab(map_, tr("Unevenness"));
    pictures_->setMinimumHeight(leastPicture);
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(table_);
    column->addWidget(makePhotoButtons());
    column->addWidget(makeFields());
    column->addWidget(makeRulers());
    column->addWidget(words_);
    column->addWidget(pictures_, 1);
    column->addWidget(photoWords_);
    column->addWidget(makeResultButtons());
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(inside);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
        enable();
        showPicture();
    });
    setFilm({}, 0);
    setMeasured(nullptr);
}

NumberBox* FilmPage::box(const char* name, double minimum, double maximum, double step,
                         const QString& suffix, const QString& nothing) {
    auto* box = new NumberBox;
    box->setObjectName(QLatin1String(name));
    box->setDecimals(step < 0.01 ? 4 : 2);
    box->setRange(minimum, maximum);
    box->setSingleStep(step);
    box->setSuffix(suffix);
    box->setSpecialValueText(nothing);
    box->setMinimumWidth(88);        // “100.25 mm”
    box->setKeyboardTracking(false); // a typed number is one change
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, box] { change(box->objectName()); });
    return box;
}

QWidget* FilmPage::makeFields() {
    begin_ = box("dipBegins", 0, longestWatch, 1, tr(" s"));
    begin_->setToolTip(tr("Seconds from laying the film on the water to the start of the dip. The "
                          "swell is computed for this time."));
    water_ = box("waterTemperature", none, 100, 1, tr(" °C"), tr("not measured"));
    water_->setToolTip(tr("Temperature of the water. It is kept with the measurement and does not "
                          "change it."));
    lot_->setToolTip(tr("Number of the film's lot. It is kept with the measurement and printed on "
                        "the pages."));
    lot_->setObjectName(QStringLiteral("filmLot"));
    lot_->setMaxLength(100);
    connect(lot_, &QLineEdit::textEdited, this, [this] { change(lot_->objectName()); });
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Dip begins after"), begin_);
    form->addRow(tr("Lot"), lot_);
    form->addRow(tr("Water temperature"), water_);
    return fields;
}

QWidget* FilmPage::makeRulers() {
    const QString millimetres = tr(" mm");
    for (int part = 0; part < 2; ++part) {
        const auto at = std::size_t(part);
        cardRulers_[at] =
            box(part == 0 ? "cardAcross" : "cardDown", leastRuler, mostRuler, 0.1, millimetres);
        filmRulers_[at] =
            box(part == 0 ? "filmAcross" : "filmDown", leastRuler, mostRuler, 0.1, millimetres);
        const QString which = part == 0 ? tr("Measured length of the horizontal ruler")
                                        : tr("Measured length of the vertical ruler");
        for (NumberBox* one : {cardRulers_[at], filmRulers_[at]}) {
            one->setToolTip(which);
            one->setAccessibleName(which);
        }
    }
    rulerError_ = box("rulerError", 0, mostRulerError, 0.05, millimetres);
    rulerError_->setToolTip(tr("Reading error of each ruler. A larger reading error gives a wider "
                               "95 % interval of the swell."));
    cardAbove_ = box("cardAbove", -mostCardAbove, mostCardAbove, 0.5, millimetres);
    focal_ = box("focalLength", none, mostFocal, 1, millimetres, tr("from the photos"));
    focal_->setToolTip(tr("Focal length of the lens as 35 mm equivalent. Needed only if the card "
                          "lies above the film."));
    k1_ = box("lensK1", unknownLens, 1, 0.001, {}, tr("k1 ?"));
    k2_ = box("lensK2", unknownLens, 1, 0.001, {}, tr("k2 ?"));
    for (NumberBox* one : {k1_, k2_}) {
        one->setToolTip(tr("Coefficients of the lens distortion of a calibrated camera. “?”: the "
                           "coefficient is found from each photo."));
    }
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(12, 0, 0, 0);
    form->addRow(tr("Rulers on the card"), side(cardRulers_[0], cardRulers_[1]));
    form->addRow(tr("Rulers on the dry film"), side(filmRulers_[0], filmRulers_[1]));
    form->addRow(tr("Reading error ±"), rulerError_);
    form->addRow(tr("Card height above film"), cardAbove_);
    form->addRow(tr("Focal length"), focal_);
    form->addRow(tr("Distortion"), side(k1_, k2_));
    auto* fold = new QToolButton;
    fold->setObjectName(QStringLiteral("filmRulers"));
    fold->setText(tr("Rulers and camera"));
    fold->setToolTip(tr("Readings of the printed rulers, height of the card, and camera data"));
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold->setArrowType(Qt::RightArrow);
    fold->setAutoRaise(true);
    fold->setCheckable(true);
    fold->setFocusPolicy(Qt::StrongFocus);
    connect(fold, &QToolButton::toggled, fields, [fold, fields](bool open) {
        fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        fields->setVisible(open);
    });
    fields->hide();
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(fold);
    column->addWidget(fields);
    return both;
}

QWidget* FilmPage::makePhotoButtons() {
    pages_ = new QPushButton(tr("Pages to p&rint…"));
    pages_->setObjectName(QStringLiteral("filmPages"));
    pages_->setToolTip(tr("Saves the chessboard for the film (film.pdf) and the card (card.pdf) to "
                          "a folder. Print the film's page on the film and the card's page on "
                          "stiff, waterproof cardboard, both at 100 %."));
    connect(pages_, &QPushButton::clicked, this, &FilmPage::pagesAsked);
    auto* add = new QPushButton(icon(QStringLiteral("add")), tr("Add &photos…"));
    add->setObjectName(QStringLiteral("addFilmPhotos"));
    remove_ = new QPushButton(tr("&Remove"));
    remove_->setObjectName(QStringLiteral("removeFilmPhotos"));
    measure_ = new QPushButton(tr("&Measure"));
    measure_->setObjectName(QStringLiteral("measureFilm"));
    connect(add, &QPushButton::clicked, this, [this] {
        const QStringList files = QFileDialog::getOpenFileNames(
            this, tr("Photos of the film"), {}, tr("Photos (%1)").arg(photoPatterns().join(u' ')));
        if (!files.isEmpty()) {
            emit photosChosen(files);
        }
    });
    connect(remove_, &QPushButton::clicked, this, &FilmPage::removeChosen);
    connect(measure_, &QPushButton::clicked, this, &FilmPage::measureAsked);
    auto* all = new QWidget;
    auto* rows = new QVBoxLayout(all);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(inARow({add, remove_, measure_}));
    rows->addWidget(inARow({pages_}));
    return all;
}

QWidget* FilmPage::makeResultButtons() {
    save_ = new QPushButton(tr("&Save to profile…"));
    save_->setObjectName(QStringLiteral("saveFilmProfile"));
    export_ = new QPushButton(tr("&Export…"));
    export_->setObjectName(QStringLiteral("exportFilm"));
    connect(save_, &QPushButton::clicked, this, &FilmPage::saveAsked);
    connect(export_, &QPushButton::clicked, this, &FilmPage::exportAsked);
    return inARow({save_, export_});
}

void FilmPage::setFilm(const FilmOnWater& film, double profileBegin) {
    const bool samePhotos =
        film.photos == film_.photos && table_->rowCount() == int(film.photos.size());
    film_ = film;
    profileBegin_ = profileBegin;
    shows_ = true;
    begin_->setValue(film.dipBegins.value_or(Seconds(profileBegin)).value());
    if (lot_->text() != film.lot) { // keeps the cursor where the user types
        lot_->setText(film.lot);
    }
    water_->setValue(film.waterTemperature.value_or(none));
    for (std::size_t part = 0; part < 2; ++part) {
        cardRulers_[part]->setValue(film.cardRulers[part].value());
        filmRulers_[part]->setValue(film.filmRulers[part].value());
    }
    rulerError_->setValue(film.rulerError.value());
    cardAbove_->setValue(film.cardAbove.value());
    focal_->setValue(film.focalAs35 ? film.focalAs35->value() : none);
    k1_->setValue(film.lensK1.value_or(k1_->minimum()));
    k2_->setValue(film.lensK2.value_or(k2_->minimum()));
    if (!samePhotos) {
        showPhotos();
    }
    shows_ = false;
    enable();
}

void FilmPage::showPhotos() {
    table_->setRowCount(int(film_.photos.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const FloatingPhoto& photo = film_.photos[std::size_t(row)];
        auto* name = new QTableWidgetItem(QFileInfo(photo.file).fileName());
        name->setToolTip(photo.file);
        name->setFlags(name->flags() & ~Qt::ItemIsEditable);
        table_->setItem(row, 0, name);
        auto* seconds = qobject_cast<NumberBox*>(table_->cellWidget(row, 1));
        if (!seconds) {
            seconds =
                box("photoSeconds", none, longestWatch, 1, tr(" s"), tr("at the start of the dip"));
            seconds->setAccessibleName(tr("Seconds since the film was laid on the water"));
            table_->setCellWidget(row, 1, seconds);
        }
        seconds->setValue(photo.seconds.value_or(none));
    }
}

void FilmPage::change(const QString& what) {
    if (shows_) {
        return;
    }
    FilmOnWater film = film_;
    for (int row = 0; row < table_->rowCount(); ++row) {
        film.photos[std::size_t(row)].seconds =
            valueOf(*qobject_cast<NumberBox*>(table_->cellWidget(row, 1)));
    }
    if (begin_->value() != film.dipBegins.value_or(Seconds(profileBegin_)).value()) {
        film.dipBegins = Seconds(begin_->value());
    }
    film.lot = lot_->text();
    film.waterTemperature = valueOf(*water_);
    for (std::size_t part = 0; part < 2; ++part) {
        film.cardRulers[part] = Millimetres(cardRulers_[part]->value());
        film.filmRulers[part] = Millimetres(filmRulers_[part]->value());
    }
    film.rulerError = Millimetres(rulerError_->value());
    film.cardAbove = Millimetres(cardAbove_->value());
    const auto focal = valueOf(*focal_, leastFocal);
    film.focalAs35 = focal ? std::optional(Millimetres(*focal)) : std::nullopt;
    film.lensK1 = valueOf(*k1_, -1);
    film.lensK2 = valueOf(*k2_, -1);
    emit filmChanged(film, what);
}

void FilmPage::removeChosen() {
    QSet<int> chosen;
    for (const QTableWidgetItem* item : table_->selectedItems()) {
        chosen.insert(item->row());
    }
    FilmOnWater film = film_;
    film.photos.clear();
    for (std::size_t i = 0; i < film_.photos.size(); ++i) {
        if (!chosen.contains(int(i))) {
            film.photos.push_back(film_.photos[i]);
        }
    }
    emit filmChanged(film, {});
}

void FilmPage::setMeasured(std::shared_ptr<const WatchedFilm> measured) {
    measured_ = std::move(measured);
    words_->setText(measured_ ? watchSentences(measured_->watch).join(u'\n') : hintText());
    showPicture();
    enable();
}

// Shows the photo selected in the table, else the last photo.
void FilmPage::showPicture() {
    if (!measured_) {
        boards_->clear();
        map_->clear();
        photoWords_->clear();
        return;
    }
    const std::vector<WatchedPhoto>& photos = measured_->watch.photos; // sorted by time
    const int row = table_->currentRow();
    const QString file =
        row >= 0 && row < int(film_.photos.size()) && !table_->selectedItems().isEmpty()
            ? film_.photos[std::size_t(row)].file
            : photos.back().where;
    const auto found = std::find_if(photos.begin(), photos.end(),
                                    [&](const WatchedPhoto& photo) { return photo.where == file; });
    const WatchedPhoto& photo = found == photos.end() ? photos.back() : *found;
    const QImage& boards = measured_->boards[std::size_t(&photo - photos.data())];
    boards_->setPicture(boards, QSizeF(boards.size()) / mapPixelsPerMillimetre);
    photoWords_->setText(tr("%1: %2 corners on the film, %3 on the card, residual %4 px")
                             .arg(QFileInfo(photo.where).fileName())
                             .arg(photo.film.corners.size())
                             .arg(photo.film.cardCorners.size())
                             .arg(numberText(photo.film.residualPixels, 3)));
    const QImage map = unevennessMap(photo, mapHeight);
    map_->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
}

void FilmPage::setBusy(bool busy) {
    busy_ = busy;
    enable();
}

void FilmPage::enable() {
    remove_->setEnabled(!table_->selectedItems().isEmpty() && !busy_);
    measure_->setEnabled(!film_.photos.empty() && !busy_);
    pages_->setEnabled(!busy_);
    save_->setEnabled(measured_ && !busy_);
    export_->setEnabled(measured_ && !busy_);
}

void FilmPage::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void FilmPage::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    emit photosChosen(droppedFiles(*event->mimeData()));
}

} // namespace dipwright
