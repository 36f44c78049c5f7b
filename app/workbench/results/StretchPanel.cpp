#include "workbench/results/StretchPanel.h"

#include "results/Results.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/ShippedNames.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace dipwright {

namespace {

QDoubleSpinBox* rangeBox(const QString& name) {
    auto* box = new NumberBox;
    box->setRange(0, 100);
    box->setDecimals(2);
    box->setSingleStep(0.05);
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    box->setToolTip(name);
    return box;
}

constexpr double shownPixels = 900;  // the map's longer edge
constexpr int exportedPixels = 2400; // the map's longer edge in a file

// Returns the spacing of isolines that divides the range into about ten parts.
double isolineStep(const HeatScale& scale) {
    for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
        if ((scale.high - scale.low) / step <= 12) {
            return step;
        }
    }
    return 1;
}

} // namespace

StretchPanel::StretchPanel(QWidget* parent)
    : QWidget(parent), quantityBox_(new QComboBox), mapBox_(new QComboBox),
      automaticBox_(new QCheckBox(tr("Automatic range"))), lowBox_(rangeBox(tr("Lowest value"))),
      highBox_(rangeBox(tr("Highest value"))), limitTick_(new QCheckBox(tr("Mark above"))),
      limitBox_(rangeBox(tr("Limit above which film is marked"))),
      isolineTick_(new QCheckBox(tr("Isolines"))), exportButton_(new QToolButton),
      view_(new PictureView), histogram_(new Histogram), summary_(new QLabel) {
    fillFields();
    makeExportButton();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    auto* top = new QHBoxLayout;
    top->addWidget(quantityBox_, 1);
    top->addWidget(mapBox_, 1);
    top->addWidget(exportButton_);
    layout->addLayout(top);
    layout->addWidget(view_, 1);
    layout->addWidget(histogram_);
    makeScaleRow(*layout);
    layout->addWidget(summary_);

    connectFields();
    redraw();
}

void StretchPanel::fillFields() {
    quantityBox_->setObjectName(QStringLiteral("stretchQuantity"));
    quantityBox_->addItem(tr("Stretch"), int(FilmQuantity::Length));
    quantityBox_->addItem(tr("Area stretch"), int(FilmQuantity::Area));
    quantityBox_->addItem(tr("Largest stretch"), int(FilmQuantity::Larger));
    quantityBox_->addItem(tr("Smallest stretch"), int(FilmQuantity::Smaller));
    quantityBox_->setItemData(0,
                              tr("Length after the dip divided by length before it, averaged over "
                                 "the directions around each point."),
                              Qt::ToolTipRole);
    quantityBox_->setItemData(
        1, tr("Area after the dip divided by area before it. The ink thins by this factor."),
        Qt::ToolTipRole);
    quantityBox_->setItemData(
        2, tr("The stretch in the direction in which the film is stretched most."),
        Qt::ToolTipRole);
    quantityBox_->setItemData(3,
                              tr("The stretch in the direction in which the film is stretched "
                                 "least. Below 1, the film wrinkles."),
                              Qt::ToolTipRole);
    quantityBox_->setAccessibleName(tr("Quantity"));
    quantityBox_->setToolTip(tr("What the map shows."));
    automaticBox_->setToolTip(
        tr("Fits the colours to the values on the part. If off, the scale runs between the two "
           "numbers on the right, so that you can compare maps."));
    limitTick_->setToolTip(tr("Shows all film over the limit in one warning colour."));
    isolineTick_->setToolTip(tr("Lines of equal value on the map."));
    for (const QString& map : colourMaps()) {
        mapBox_->addItem(shownTitle(map), map);
    }
    mapBox_->setAccessibleName(tr("Colour map"));
    mapBox_->setToolTip(tr("Colour map; all are safe for colour-blind readers."));
    automaticBox_->setChecked(true);
    highBox_->setValue(2);
    lowBox_->setValue(1);
    limitBox_->setValue(1.3);
    isolineTick_->setObjectName(QStringLiteral("isolines"));
    view_->setObjectName(QStringLiteral("stretchMap"));
    view_->setAccessibleName(tr("Stretch map"));
    summary_->setWordWrap(true);
    summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void StretchPanel::makeExportButton() {
    exportButton_->setIcon(icon(QStringLiteral("export")));
    exportButton_->setText(tr("Export"));
    exportButton_->setToolTip(tr("Save the map or its numbers"));
    exportButton_->setPopupMode(QToolButton::InstantPopup);
    exportButton_->setAutoRaise(true);
    auto* menu = new QMenu(exportButton_);
    const auto addExport = [this, menu](const QString& text, const QString& suffix) {
        menu->addAction(text, this, [this, suffix] { emit exportAsked(suffix); });
    };
    addExport(tr("Picture (PNG)…"), QStringLiteral("png"));
    addExport(tr("Table (CSV)…"), QStringLiteral("csv"));
    addExport(tr("Film (VTP)…"), QStringLiteral("vtp"));
    exportButton_->setMenu(menu);
}

void StretchPanel::connectFields() {
    for (QComboBox* box : {quantityBox_, mapBox_}) {
        connect(box, &QComboBox::currentIndexChanged, this, &StretchPanel::redraw);
    }
    for (QCheckBox* box : {automaticBox_, limitTick_, isolineTick_}) {
        connect(box, &QCheckBox::toggled, this, &StretchPanel::redraw);
    }
    for (QDoubleSpinBox* box : {lowBox_, highBox_, limitBox_}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &StretchPanel::redraw);
    }
    connect(view_, &PictureView::hovered, this, [this](QPointF place) {
        const auto& grid = reading_->film().grid;
        emit hovered({float(place.x() - grid.width / 2), float(place.y() - grid.depth / 2)});
    });
    connect(view_, &PictureView::hoverLeft, this, &StretchPanel::hoverLeft);
}

void StretchPanel::makeScaleRow(QVBoxLayout& layout) {
    auto* range = new QHBoxLayout;
    range->addWidget(automaticBox_);
    range->addStretch();
    range->addWidget(lowBox_);
    range->addWidget(new QLabel(QStringLiteral("–")));
    range->addWidget(highBox_);
    layout.addLayout(range);
    auto* marks = new QHBoxLayout;
    marks->addWidget(limitTick_);
    marks->addWidget(limitBox_);
    marks->addStretch();
    marks->addWidget(isolineTick_);
    layout.addLayout(marks);
}

void StretchPanel::setReading(std::shared_ptr<const FilmReadout> reading, bool isDraft) {
    reading_ = std::move(reading);
    isDraft_ = isDraft;
    redraw();
}

FilmQuantity StretchPanel::quantity() const {
    return FilmQuantity(quantityBox_->currentData().toInt());
}

void StretchPanel::redraw() {
    lowBox_->setEnabled(!automaticBox_->isChecked());
    highBox_->setEnabled(!automaticBox_->isChecked());
    limitBox_->setEnabled(limitTick_->isChecked());
    exportButton_->setEnabled(reading_ && !isDraft_);
    scale_.map = mapBox_->currentData().toString();
    scale_.limit.reset();
    if (limitTick_->isChecked()) {
        scale_.limit = limitBox_->value();
    }
    scale_.low = lowBox_->value();
    scale_.high = std::max(scale_.low + 0.01, highBox_->value());
    if (!reading_) {
        view_->clear(tr("Run the dip to see how the film stretches."));
        histogram_->setValues({}, scale_);
        summary_->clear();
        emit scaleChanged();
        return;
    }
    const std::vector<float>& painted = reading_->paintedValues(quantity());
    if (automaticBox_->isChecked()) {
        scale_ = automaticScale(scale_, painted);
        const QSignalBlocker quietLow(lowBox_), quietHigh(highBox_);
        lowBox_->setValue(scale_.low);
        highBox_->setValue(scale_.high);
    }
    view_->setPicture(heatMap(shownPixels), filmSize());
    view_->setLines(shownIsolines());
    histogram_->setValues(painted, scale_);
    const Distribution& spread = reading_->spread(quantity());
    const auto number = [this](double value) { return locale().toString(value, 'f', 3); };
    summary_->setText(
        tr("On the part: mean %1 · 95 % below %2 · largest %3")
            .arg(number(spread.mean), number(spread.percentile95), number(spread.maximum)));
    emit scaleChanged();
}

QSizeF StretchPanel::filmSize() const {
    const solver::FilmGrid& grid = reading_->film().grid;
    return {grid.width, grid.depth};
}

QImage StretchPanel::heatMap(double longestEdge) const {
    const solver::FilmGrid& grid = reading_->film().grid;
    const double pixels = longestEdge / std::max(grid.width, grid.depth);
    return heatPicture(reading_->values(quantity()), grid, (filmSize() * pixels).toSize(), scale_);
}

QList<QLineF> StretchPanel::shownIsolines() const {
    if (!isolineTick_->isChecked()) {
        return {};
    }
    return isolines(reading_->values(quantity()), reading_->film().grid, isolineStep(scale_));
}

QImage StretchPanel::picture() const {
    const QImage map = heatMap(exportedPixels);
    const double perMillimetre = map.width() / filmSize().width();
    const int margin = exportedPixels / 40, keyHeight = exportedPixels / 7;
    QImage picture(map.width() + 2 * margin, map.height() + 4 * margin + keyHeight,
                   QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(margin * 2 / 3);
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(QRect(margin, 0, map.width(), 2 * margin), Qt::AlignVCenter,
                     QStringLiteral("%1 · %2").arg(quantityBox_->currentText(), summary_->text()));
    painter.drawImage(margin, 2 * margin, map);
    histogram_->paint(painter, QRectF(margin, map.height() + 3.0 * margin, map.width(), keyHeight),
                      Qt::black);
    painter.translate(margin, 2 * margin);
    painter.scale(perMillimetre, perMillimetre);
    painter.setPen(QPen(QColor(0, 0, 0, 170), 2 / perMillimetre));
    painter.drawLines(shownIsolines());
    return picture;
}

void StretchPanel::showReading(const std::optional<FilmReadoutPoint>& point) {
    if (!point || !reading_) {
        view_->setCursorAt({});
        histogram_->setMark({});
        return;
    }
    const solver::FilmGrid& grid = reading_->film().grid;
    view_->setCursorAt(QPointF(double(point->rest.x()) + grid.width / 2,
                               double(point->rest.y()) + grid.depth / 2));
    histogram_->setMark(double(point->values[std::size_t(quantity())]));
}

} // namespace dipwright
