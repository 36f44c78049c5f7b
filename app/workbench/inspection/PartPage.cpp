#include "workbench/inspection/PartPage.h"

#include "base/NumberText.h"
#include "import/trusted/ReadPhotos.h"
#include "workbench/widgets/DroppedFiles.h"
#include "workbench/widgets/Icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace dipwright {

namespace {

QStringList cells(const PartFigures& figures) {
    return {QString::number(figures.count),
            PartPage::tr("%1 ± %2").arg(numberText(figures.meanPixels, 2),
                                        numberText(figures.deviationPixels, 2)),
            numberText(100 * figures.shareOfDiagonal, 3), numberText(figures.percentile95, 2),
            numberText(figures.worst, 2)};
}

QToolButton* toolButton(const char* name, const char* picture, const QString& help) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setIcon(icon(QLatin1String(picture)));
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

PartPage::PartPage(QWidget* parent)
    : QWidget(parent), view_(new PhotoView), hint_(new QLabel), figures_(new QTableWidget) {
    setAcceptDrops(true);
    view_->setObjectName(QStringLiteral("partPhoto"));
    view_->setAccessibleName(tr("Photo of the dipped part"));
    hint_->setObjectName(QStringLiteral("partHint"));
    hint_->setWordWrap(true);
    figures_->setObjectName(QStringLiteral("partFigures"));
    figures_->setAccessibleName(tr("Error of the image on the part"));
    figures_->setColumnCount(5);
    figures_->setHorizontalHeaderLabels(
        {tr("N"), tr("R ± σ, px"), tr("R, %"), tr("95 %, mm"), tr("Largest, mm")});
    const QStringList help{
        tr("N: number of measured places"),
        tr("R: mean distance in the photo between the measured and the expected position of a "
           "place, ± standard deviation σ, in pixels"),
        tr("R as a share of the photo's diagonal, as in Table II of the 2020 paper"),
        tr("95 % of the places on the part are within this distance of their expected positions, "
           "measured perpendicular to the line of sight"),
        tr("Largest distance of a place on the part from its expected position, measured "
           "perpendicular to the line of sight")};
    for (int column = 0; column < help.size(); ++column) {
        figures_->horizontalHeaderItem(column)->setToolTip(help[column]);
    }
    figures_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    figures_->horizontalHeader()->setMinimumSectionSize(20);
    for (const int column : {0, 1}) {
        figures_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    figures_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    figures_->setMaximumHeight(150);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makePhotoBar());
    layout->addWidget(view_, 1);
    layout->addWidget(hint_);
    layout->addWidget(makeMeasureBar());
    layout->addWidget(figures_);
    connect(view_, &PhotoView::clicked, this, [this](QPointF place) { setPending(place); });
    connect(view_, &PhotoView::markChosen, this, [this](int mark) {
        chosen_ = shown_[std::size_t(mark)];
        enable();
        emit pairChosen(chosen_);
    });
    connect(view_, &PhotoView::markDragged, this,
            [this](int mark, QPointF place) { emit pairMoved(shown_[std::size_t(mark)], place); });
    connect(view_, &PhotoView::markDropped, this, &PartPage::pairDropped);
    connect(view_, &PhotoView::removeAsked, this,
            [this](int mark) { emit removePairAsked(shown_[std::size_t(mark)]); });
    setPart({});
}

QWidget* PartPage::makePhotoBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    auto* add = new QPushButton(icon(QStringLiteral("add")), tr("Add &photos…"));
    add->setObjectName(QStringLiteral("addPartPhotos"));
    photos_ = new QComboBox;
    photos_->setObjectName(QStringLiteral("partPhotos"));
    photos_->setAccessibleName(tr("Photo"));
    photos_->setToolTip(tr("The photo that is shown."));
    photos_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    removePhoto_ = new QPushButton(icon(QStringLiteral("remove")), {});
    removePhoto_->setObjectName(QStringLiteral("removePartPhoto"));
    removePhoto_->setToolTip(tr("Remove this photo and its pairs"));
    removePhoto_->setAccessibleName(tr("Remove photo"));
    auto* whole = toolButton("wholePhoto", "fit", tr("Whole picture"));
    auto* nearer = toolButton("nearerPhoto", "zoom-in", tr("Zoom in"));
    auto* farther = toolButton("fartherPhoto", "zoom-out", tr("Zoom out"));
    row->addWidget(add);
    row->addWidget(photos_, 1);
    row->addWidget(removePhoto_);
    for (QToolButton* button : {whole, nearer, farther}) {
        row->addWidget(button);
    }
    connect(add, &QPushButton::clicked, this, [this] {
        const QStringList files =
            QFileDialog::getOpenFileNames(this, tr("Photos of the dipped part"), {},
                                          tr("Photos (%1)").arg(photoPatterns().join(u' ')));
        if (!files.isEmpty()) {
            emit photosChosen(files);
        }
    });
    connect(photos_, &QComboBox::currentIndexChanged, this, &PartPage::lookAt);
    connect(removePhoto_, &QPushButton::clicked, this, [this] { emit removePhotoAsked(photo_); });
    connect(whole, &QToolButton::clicked, view_, &PictureView::zoomToFit);
    connect(nearer, &QToolButton::clicked, this, [this] { view_->zoomBy(1.25); });
    connect(farther, &QToolButton::clicked, this, [this] { view_->zoomBy(0.8); });
    return bar;
}

QWidget* PartPage::makeMeasureBar() {
    auto* bar = new QWidget;
    auto* rows = new QVBoxLayout(bar);
    rows->setContentsMargins(0, 0, 0, 0);
    chessboard_ = new QCheckBox(tr("Dipped with the c&hessboard film (17 mm)"));
    chessboard_->setObjectName(QStringLiteral("partChessboard"));
    chessboard_->setToolTip(
        tr("If ticked, the program looks for the corners of the built-in chessboard. Otherwise it "
           "looks for chessboard squares in the model's texture."));
    keepsCamera_ = new QCheckBox(tr("The pairs mark the part &itself, not the image"));
    keepsCamera_->setObjectName(QStringLiteral("partKeepsCamera"));
    keepsCamera_->setToolTip(tr(
        "Tick this if the pairs are tips and edges of the part, not places in the image. Then the "
        "camera is fitted only to the pairs, so that a shift of the whole image becomes visible."));
    rows->addWidget(chessboard_);
    rows->addWidget(keepsCamera_);
    auto* row = new QHBoxLayout;
    camera_ = new QPushButton(tr("&Measure pairs"));
    camera_->setObjectName(QStringLiteral("measurePairs"));
    camera_->setToolTip(tr("Fits the camera to the pairs and shows their residuals"));
    corners_ = new QPushButton(tr("&Find corners"));
    corners_->setObjectName(QStringLiteral("findCorners"));
    corners_->setToolTip(tr(
        "Finds the corners of the image in all photos and compares them with the simulated film"));
    removePair_ = new QPushButton(tr("&Remove pair"));
    removePair_->setObjectName(QStringLiteral("removePair"));
    export_ = new QPushButton(tr("&Export…"));
    export_->setObjectName(QStringLiteral("exportPart"));
    export_->setToolTip(
        tr("Writes the table, the places and the photos with residuals to a folder"));
    for (QPushButton* button : {corners_, camera_, removePair_, export_}) {
        row->addWidget(button);
    }
    row->addStretch();
    rows->addLayout(row);
    connect(chessboard_, &QCheckBox::clicked, this, &PartPage::chessboardChosen);
    connect(keepsCamera_, &QCheckBox::clicked, this, &PartPage::keepsCameraChosen);
    connect(camera_, &QPushButton::clicked, this, &PartPage::cameraAsked);
    connect(corners_, &QPushButton::clicked, this, &PartPage::cornersAsked);
    connect(removePair_, &QPushButton::clicked, this, [this] { emit removePairAsked(chosen_); });
    connect(export_, &QPushButton::clicked, this, &PartPage::exportAsked);
    return bar;
}

void PartPage::setPart(const InspectedPart& part) {
    const bool samePhotos = part.photos == part_.photos && photos_->count() > 0;
    part_ = part;
    chessboard_->setChecked(part.chessboard);
    keepsCamera_->setChecked(part.keepsCamera);
    if (chosen_ >= int(part.pairs.size())) {
        chosen_ = -1;
    }
    if (!samePhotos) {
        const QSignalBlocker quiet(photos_);
        const bool isMore = photos_->count() < int(part.photos.size());
        photos_->clear();
        for (std::size_t i = 0; i < part.photos.size(); ++i) {
            photos_->addItem(
                QStringLiteral("%1  %2").arg(i + 1).arg(QFileInfo(part.photos[i].file).fileName()));
        }
        const int last = int(part.photos.size()) - 1;
        photos_->setCurrentIndex(isMore ? last : std::min(std::max(photo_, 0), last));
        lookAt(photos_->currentIndex());
    }
    showMarks();
    enable();
    say();
}

void PartPage::lookAt(int photo) {
    photo_ = photo;
    chosen_ = -1;
    setPending({});
    showMarks();
    emit photoLookedAt(photo);
}

void PartPage::setPicture(const QImage& picture, const QString& hint) {
    picture.isNull() ? view_->clear(hint) : view_->setPhoto(picture);
    showMarks();
    say();
}

void PartPage::setPending(const std::optional<QPointF>& place) {
    pending_ = place;
    view_->setPending(place);
    say();
}

void PartPage::setMeasured(std::shared_ptr<const MeasuredPart> measured) {
    measured_ = std::move(measured);
    showMarks();
    showFigures();
    enable();
    say();
}

void PartPage::setBusy(bool busy) {
    busy_ = busy;
    enable();
}

void PartPage::showMarks() {
    QList<QPointF> marks;
    shown_.clear();
    for (std::size_t i = 0; i < part_.pairs.size(); ++i) {
        const ClickedPair& pair = part_.pairs[i];
        if (pair.photo == photo_) {
            marks.append({pair.pixel[0], pair.pixel[1]});
            shown_.push_back(int(i));
        }
    }
    view_->setMarks(marks);
    const auto chosen = std::find(shown_.begin(), shown_.end(), chosen_);
    view_->setChosen(chosen == shown_.end() ? -1 : int(chosen - shown_.begin()));
    QList<QLineF> residuals;
    for (std::size_t i = 0; measured_ && i < measured_->pairs.size(); ++i) {
        const PlacePair& pair = measured_->pairs[i];
        if (pair.photo == photo_) {
            const Eigen::Vector2d expected = pair.pixel - measured_->view.off[i].pixels;
            residuals.append(QLineF(expected.x(), expected.y(), pair.pixel.x(), pair.pixel.y()));
        }
    }
    view_->setResiduals(residuals);
}

void PartPage::showFigures() {
    figures_->setRowCount(0);
    figures_->setVisible(measured_ != nullptr);
    if (!measured_) {
        return;
    }
    const auto add = [this](const QString& name, const PartFigures& figures) {
        const int row = figures_->rowCount();
        figures_->insertRow(row);
        figures_->setVerticalHeaderItem(row, new QTableWidgetItem(name));
        const QStringList texts = cells(figures);
        for (int column = 0; column < texts.size(); ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            figures_->setItem(row, column, item);
        }
    };
    const std::size_t count = measured_->photos.size();
    for (std::size_t i = 0; count > 1 && i < count; ++i) {
        add(tr("Photo %1").arg(i + 1), figuresOfPhoto(measured_->view, measured_->pairs, int(i),
                                                      measured_->photos[i].picture.size()));
    }
    add(tr("All"), measured_->view.figures);
}

void PartPage::enable() {
    const bool hasPhoto = photo_ >= 0;
    removePhoto_->setEnabled(hasPhoto && !busy_);
    removePair_->setEnabled(chosen_ >= 0);
    camera_->setEnabled(hasPhoto && !busy_);
    corners_->setEnabled(hasPhoto && !busy_);
    export_->setEnabled(measured_ && !busy_);
}

void PartPage::say() {
    if (photo_ < 0) {
        hint_->setText(
            tr("Add photos of the dipped part, or drop them here. Take all photos with the same "
               "camera. The part must be sharp, completely visible and fill the picture."));
        return;
    }
    if (pending_) {
        hint_->setText(tr("Now click the same place on the part in the 3D view."));
        return;
    }
    if (measured_) {
        QStringList lines;
        int found = 0, expected = 0;
        for (const int one : measured_->expected) {
            expected += one;
        }
        found = int(measured_->places.size());
        if (expected > 0) {
            lines << tr("%1 of %2 corners found.").arg(found).arg(expected);
            lines << (measured_->followsPrint
                          ? tr("The camera was fitted to the printed pattern, so a "
                               "shift or rotation of the whole image is not "
                               "measured.")
                          : tr("The camera was fitted to the pairs."));
            if (!measured_->doubt.isEmpty()) {
                lines << measured_->doubt + u'.';
            }
        }
        hint_->setText(lines.join(u' '));
        return;
    }
    const auto here = shown_.size();
    hint_->setText(
        here < std::size_t(leastPairs)
            ? tr("Click a place in the photo, then the same place on the part in the 3D view. %1 "
                 "of %2 pairs so far; spread them over several faces.")
                  .arg(here)
                  .arg(leastPairs)
            : tr("%1 pairs. Drag a place to correct it, or press Delete to remove it. Then click "
                 "“Find corners”, or click “Measure pairs” to use only the pairs.")
                  .arg(here));
}

void PartPage::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void PartPage::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    emit photosChosen(droppedFiles(*event->mimeData()));
}

} // namespace dipwright
