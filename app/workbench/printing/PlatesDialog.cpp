#include "workbench/printing/PlatesDialog.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "printing/PrintFile.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/prepress/Separation.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"
#include "workbench/widgets/PictureView.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMap>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double mostShownPixels = 40e6;
constexpr double usualLimit = 3;           // if the printer's profile names none
const QColor greyGround(0x80, 0x80, 0x80); // shows where white is missing

enum Column { Ink, UnderCursor, Largest, Area, Columns };

QString percent(double share, int decimals = 0) {
    return numberText(100 * share, decimals);
}

QTableWidgetItem* cell(const QString& text, Qt::Alignment alignment = Qt::AlignRight) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(alignment | Qt::AlignVCenter);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    return item;
}

QIcon swatch(const ProofPlate& plate) {
    QPixmap pixmap(16, 16);
    pixmap.fill(plate.colour);
    QPainter painter(&pixmap);
    painter.setPen(QColor(0x70, 0x70, 0x70));
    painter.drawRect(0, 0, 15, 15);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // not tinted by the selection
    return icon;
}

// Returns the name of a plate in the user's language; names of spot inks are the user's own.
QString shownInk(const ProofPlate& plate) {
    const std::array<QString, 4> names{PlatesDialog::tr("Cyan"), PlatesDialog::tr("Magenta"),
                                       PlatesDialog::tr("Yellow"), PlatesDialog::tr("Black")};
    return plate.channel < 4 ? names[std::size_t(plate.channel)] : plate.ink;
}

// What a picture shows.
struct Drawing {
    bool isGrey = false, isTotal = false;
    int channel = 0; // in grey
    std::vector<bool> channels;
    QColor ground;
    std::optional<double> limit;
};

QImage drawn(const Plates& plates, const PrinterColour& colour, const Drawing& drawing) {
    return drawing.isTotal  ? totalInkMap(plates, drawing.limit)
           : drawing.isGrey ? greyPlate(plates, drawing.channel)
                            : composite(plates, colour, drawing.channels, drawing.ground);
}

} // namespace

PlatesDialog::PlatesDialog(std::shared_ptr<const JobResult> result, std::size_t immersion,
                           LengthUnit unit, QWidget* parent)
    : QDialog(parent), result_(std::move(result)), shown_(immersion), unit_(unit),
      notice_(new QLabel),
      picture_(new PicturePanel(
          tr("Plates"), tr("Plates need a printer profile with an ICC profile in CMYK. Choose one "
                           "under Sheet in the project, and run the dip again."))),
      dip_(new QComboBox), view_(new QComboBox), ground_(new QComboBox),
      table_(new QTableWidget(0, Columns)), limit_(new NumberBox), figures_(new QLabel),
      progress_(new QProgressBar), allPlates_(new QPushButton(tr("&All plates"))),
      onlyThis_(new QPushButton(tr("&Only this plate"))), stop_(new QPushButton(tr("&Stop"))) {
    setWindowTitle(tr("Plates"));
    setObjectName(QStringLiteral("platesDialog"));
    setSizeGripEnabled(true);
    notice_->setWordWrap(true);
    notice_->hide();
    picture_->offerTrueSize();
    picture_->view().setMinimumSize(260, 260);
    picture_->view().installEventFilter(this);
    picture_->view().setToolTip(
        tr("Wheel or + and − zoom, dragging or the arrow keys move the picture. Ctrl and the arrow "
           "keys move the place whose ink is shown, by one pixel; with Shift by ten."));
    connect(&picture_->view(), &PictureView::hovered, this, [this](QPointF place) {
        const QSize size = separation_->plates->size;
        cursor_.reset();
        picture_->view().setCursorAt(std::nullopt);
        showInkAt(QPoint(
            std::clamp(int(place.x() / film().width() * size.width()), 0, size.width() - 1),
            std::clamp(int(place.y() / film().height() * size.height()), 0, size.height() - 1)));
    });
    connect(&picture_->view(), &PictureView::hoverLeft, this, [this] { showInkAt(cursor_); });
    auto* both = new QHBoxLayout;
    both->addWidget(picture_, 1);
    both->addWidget(makeSide());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(progress_, 1);
    bottom->addWidget(stop_);
    bottom->addWidget(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(notice_);
    layout->addLayout(both, 1);
    layout->addLayout(bottom);
    progress_->setRange(0, 1000);
    stop_->setAutoDefault(false);
    stop_->setObjectName(QStringLiteral("platesStop"));
    stop_->setToolTip(tr("Stops the computation. Choose another view or sheet to start again."));
    for (QWidget* shownWhileBusy :
         {static_cast<QWidget*>(progress_), static_cast<QWidget*>(stop_)}) {
        QSizePolicy policy = shownWhileBusy->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        shownWhileBusy->setSizePolicy(policy);
        shownWhileBusy->hide();
    }
    connect(stop_, &QPushButton::clicked, &jobs_, &JobRunner::cancelAll);
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * 1000));
        progress_->setFormat(text);
    });
    connect(&jobs_, &JobRunner::busy, this, [this] {
        progress_->show();
        stop_->show();
    });
    connect(&jobs_, &JobRunner::idle, this, [this] {
        progress_->hide();
        stop_->hide();
    });
    resize(1000, 680);
    separateSheet();
}

void PlatesDialog::warn(const QString& sentence) {
    notice_->setText(sentence);
    notice_->show();
}

QWidget* PlatesDialog::makeSide() {
    for (const ImmersionResult& dip : result_->immersions) {
        dip_->addItem(dip.immersion.name);
    }
    dip_->setCurrentIndex(int(shown_));
    dip_->setEnabled(dip_->count() > 1);
    dip_->setToolTip(tr("The dip whose sheet is shown."));
    view_->addItems({tr("Ticked plates in ink colours"), tr("Selected plate in grey"),
                     tr("Total ink of the four inks")});
    view_->setObjectName(QStringLiteral("platesView"));
    view_->setToolTip(tr("What the picture shows. In grey, black is full ink. Total ink is the sum "
                         "of cyan, magenta, yellow and black; red is above the limit."));
    ground_->addItems({tr("White"), tr("Grey"), tr("Colour of the part")});
    if (result_->project.baseColour.isEmpty()) {
        ground_->removeItem(2);
    }
    ground_->setToolTip(tr("What lies beneath the inks in the picture. White ink shows only on "
                           "another ground than white."));
    const auto& profile = result_->project.profiles.printer;
    limit_->setObjectName(QStringLiteral("platesLimit"));
    limit_->setDecimals(0);
    limit_->setRange(10, 400);
    limit_->setSuffix(tr(" %"));
    limit_->setKeyboardTracking(false);
    limit_->setValue(100 * (profile ? profile->totalInk : std::nullopt).value_or(usualLimit));
    limit_->setToolTip(tr("The largest sum of the four inks that the film carries. Places above it "
                          "are marked and measured. It starts at the printer profile's total area "
                          "coverage. Usual: 200 to 300 %. The print does not change."));
    makeTable();
    connect(dip_, &QComboBox::currentIndexChanged, this, [this](int number) {
        shown_ = std::size_t(number);
        separateSheet();
    });
    connect(view_, &QComboBox::currentIndexChanged, this, &PlatesDialog::draw);
    connect(ground_, &QComboBox::currentIndexChanged, this, &PlatesDialog::draw);
    connect(limit_, &NumberBox::valueChanged, this, &PlatesDialog::measure);
    auto* form = new QFormLayout;
    form->addRow(tr("S&heet"), dip_);
    form->addRow(tr("&View"), view_);
    form->addRow(tr("&Ground"), ground_);
    form->addRow(tr("Total ink &limit"), limit_);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {allPlates_, onlyThis_}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    figures_->setWordWrap(true);
    figures_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    figures_->setObjectName(QStringLiteral("platesFigures"));
    figures_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* side = new QWidget;
    side->setFixedWidth(380);
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(form);
    layout->addWidget(table_, 1);
    layout->addLayout(buttons);
    layout->addWidget(figures_);
    return side;
}

void PlatesDialog::makeTable() {
    table_->setObjectName(QStringLiteral("plates"));
    table_->setAccessibleName(tr("Plates in printing order"));
    table_->setHorizontalHeaderLabels(
        {tr("Plate"), tr("Cursor %"), tr("Largest %"), tr("Full ink")});
    table_->horizontalHeaderItem(UnderCursor)
        ->setToolTip(tr("The ink under the cursor, as a share of full ink."));
    table_->horizontalHeaderItem(Largest)->setToolTip(tr("The largest share of ink on the film."));
    table_->horizontalHeaderItem(Area)->setToolTip(
        tr("How much ink the plate takes, as the area that it would cover at full ink."));
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(Ink, QHeaderView::Stretch);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setToolTip(tr("Tick the plates that the picture shows. Space changes the selected "
                          "plate, a double-click shows only that plate."));
    connect(table_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
        if (item->column() == Ink) {
            draw();
        }
    });
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int, int before) {
        if (row != before && view() == View::Grey) {
            draw();
        }
    });
    const auto tick = [this](const auto& isTicked) {
        {
            const QSignalBlocker quiet(table_);
            for (int row = 0; separation_ && row < int(separation_->figures.plates.size()); ++row) {
                table_->item(row, Ink)->setCheckState(isTicked(row) ? Qt::Checked : Qt::Unchecked);
            }
        }
        draw();
    };
    const auto onlyCurrent = [this, tick] {
        tick([current = table_->currentRow()](int row) { return row == current; });
    };
    connect(table_, &QTableWidget::cellDoubleClicked, this, onlyCurrent);
    connect(onlyThis_, &QPushButton::clicked, this, onlyCurrent);
    connect(allPlates_, &QPushButton::clicked, this, [tick] { tick([](int) { return true; }); });
}

QSizeF PlatesDialog::film() const {
    return {sheet().filmWidth.value(), sheet().filmHeight.value()};
}

PlatesDialog::View PlatesDialog::view() const {
    return View(view_->currentIndex());
}

std::optional<double> PlatesDialog::limit() const {
    return limit_->value() / 100;
}

std::vector<bool> PlatesDialog::shownChannels() const {
    std::vector<bool> shown(std::size_t(separation_->plates->channels()));
    for (std::size_t row = 0; row < separation_->figures.plates.size(); ++row) {
        shown[std::size_t(separation_->figures.plates[row].plate.channel)] =
            table_->item(int(row), Ink)->checkState() == Qt::Checked;
    }
    return shown;
}

void PlatesDialog::separateSheet() {
    separation_.reset();
    cursor_.reset();
    picture_->clear();
    const auto& profile = result_->project.profiles.printer;
    const std::shared_ptr<const PrinterColour> colour = printerColour(profile);
    const bool hasPlates = colour && colour->isCmyk();
    for (QWidget* part :
         std::initializer_list<QWidget*>{view_, ground_, table_, limit_, allPlates_, onlyThis_}) {
        part->setEnabled(hasPlates);
    }
    if (!hasPlates) {
        return;
    }
    jobs_.cancelAll();
    separating_ = jobs_.start(std::make_unique<ValueJob<Separation>>(
        tr("Making the plates"),
        [sheet = sheet(), correction = printCorrection(profile, colour.get()), colour,
         limit = limit(), size = film()](const Progress& progress) {
            progress(0, tr("Making the plates"));
            Separation made{
                colour, std::make_shared<const Plates>(separate(sheet, correction)), {}, {}};
            progress(0.7, tr("Measuring the plates"));
            made.figures = inkFigures(*made.plates, *colour, size, limit);
            progress(0.9, tr("Measuring the plates"));
            const double pixels = double(made.plates->size.width()) * made.plates->size.height();
            const int factor = int(std::ceil(std::sqrt(pixels / mostShownPixels)));
            made.shown = factor > 1
                             ? std::make_shared<const Plates>(reducedPlates(*made.plates, factor))
                             : made.plates;
            return made;
        },
        [this](const Separation& made) { takeSeparation(made); },
        [this](std::exception_ptr failure) {
            separating_.reset();
            fail(failure);
        }));
}

void PlatesDialog::takeSeparation(const Separation& separation) {
    separation_ = separation;
    separating_.reset();
    fillTable();
    showFigures();
    if (separation_->figures.limit != limit()) { // changed meanwhile
        measure();
    } else {
        draw();
    }
}

void PlatesDialog::measure() {
    if (!separation_) {
        return;
    }
    jobs_.start(std::make_unique<ValueJob<InkFigures>>(
        tr("Measuring the plates"),
        [plates = separation_->plates, colour = separation_->colour, size = film(),
         limit = limit()](const Progress&) { return inkFigures(*plates, *colour, size, limit); },
        [this, plates = separation_->plates](const InkFigures& figures) {
            if (separation_ && separation_->plates == plates) {
                separation_->figures = figures;
                showFigures();
            }
        },
        [this](std::exception_ptr failure) { fail(failure); }));
    draw();
}

void PlatesDialog::draw() {
    ground_->setEnabled(view() == View::Print);
    if (!separation_) {
        if (!separating_ || separating_->isCancelled()) {
            separateSheet();
        }
        return;
    }
    const std::array<QColor, 3> grounds{QColor(Qt::white), greyGround,
                                        QColor(result_->project.baseColour)};
    const auto row = std::size_t(std::max(0, table_->currentRow()));
    const auto& plates = separation_->figures.plates;
    const Drawing drawing{view() == View::Grey,
                          view() == View::TotalInk,
                          plates[std::min(row, plates.size() - 1)].plate.channel,
                          shownChannels(),
                          grounds[std::size_t(ground_->currentIndex())],
                          limit()};
    drawn_.cancel();
    drawn_ = jobs_.start(std::make_unique<ValueJob<QImage>>(
        tr("Drawing the plates"),
        [plates = separation_->shown, colour = separation_->colour,
         drawing](const Progress& progress) {
            progress(0, tr("Drawing the plates"));
            return drawn(*plates, *colour, drawing);
        },
        [this, number = ++drawing_](const QImage& picture) {
            if (number == drawing_) {
                picture_->setPicture(picture, film());
            }
        },
        [this](std::exception_ptr failure) { fail(failure); }));
}

void PlatesDialog::fillTable() {
    const QSignalBlocker quiet(table_);
    const std::vector<PlateFigures>& plates = separation_->figures.plates;
    std::vector<bool> isTicked(plates.size(), true);
    for (int row = 0; row < std::min(table_->rowCount() - 2, int(plates.size())); ++row) {
        isTicked[std::size_t(row)] = table_->item(row, Ink)->checkState() == Qt::Checked;
    }
    table_->setRowCount(int(plates.size()) + 2);
    for (int row = 0; row < int(plates.size()); ++row) {
        const PlateFigures& one = plates[std::size_t(row)];
        QTableWidgetItem* ink = cell(shownInk(one.plate), Qt::AlignLeft);
        ink->setIcon(swatch(one.plate));
        ink->setFlags(ink->flags() | Qt::ItemIsUserCheckable);
        ink->setCheckState(isTicked[std::size_t(row)] ? Qt::Checked : Qt::Unchecked);
        table_->setItem(row, Ink, ink);
        table_->setItem(row, UnderCursor, cell({}));
        table_->setItem(row, Largest, cell(percent(one.mostTint)));
        table_->setItem(row, Area, cell(shownArea(one.fullTintArea, unit_)));
    }
    const int total = int(plates.size());
    QFont bold = table_->font();
    bold.setBold(true);
    for (const auto& [row, name, most] :
         {std::tuple(total, tr("Four inks"), separation_->figures.mostInk),
          std::tuple(total + 1, tr("All plates"), separation_->figures.mostOfAllPlates)}) {
        table_->setItem(row, Ink, cell(name, Qt::AlignLeft));
        table_->setItem(row, UnderCursor, cell({}));
        table_->setItem(row, Largest, cell(percent(most)));
        table_->setItem(row, Area, cell({}));
        for (int column = 0; column < Columns; ++column) {
            table_->item(row, column)->setFont(bold);
        }
    }
    if (table_->currentRow() < 0) {
        table_->setCurrentCell(0, Ink);
    }
}

void PlatesDialog::showFigures() {
    const InkFigures& figures = separation_->figures;
    figures_->setText(
        tr("Above the limit of %1 %: %2, %3 % of the inked film.\n"
           "95 % of the inked film carries at most %4 %. The figures are those of the film's "
           "picture; marks and lettering are printed besides it.")
            .arg(percent(figures.limit.value_or(4)), shownArea(figures.areaAbove, unit_),
                 percent(figures.shareAbove(), 2), percent(figures.ink95)) +
        (sheet().passes > 1
             ? u'\n' + tr("The sheet is printed %1 times; the figures are those of one pass.")
                           .arg(sheet().passes)
             : QString()));
}

void PlatesDialog::showInkAt(const std::optional<QPoint>& pixel) {
    if (!separation_) {
        return;
    }
    const Plates& plates = *separation_->plates;
    const int total = int(separation_->figures.plates.size());
    const QSignalBlocker quiet(table_);
    double all = 0;
    for (int row = 0; row < total; ++row) {
        const int channel = separation_->figures.plates[std::size_t(row)].plate.channel;
        const double tint = pixel ? tintAt(plates, channel, *pixel) / 255.0 : 0;
        all += tint;
        table_->item(row, UnderCursor)->setText(pixel ? percent(tint) : QString());
    }
    const double four = pixel ? inkAt(plates, *pixel) : 0;
    const bool isAbove = pixel && four > *limit() + 1e-6;
    table_->item(total, UnderCursor)
        ->setText(!pixel    ? QString()
                  : isAbove ? tr("%1 > limit").arg(percent(four))
                            : percent(four));
    table_->item(total + 1, UnderCursor)->setText(pixel ? percent(all) : QString());
    table_->viewport()->update();
}

void PlatesDialog::moveCursor(QPoint by) {
    const QSize size = separation_->plates->size;
    const QPoint from = cursor_.value_or(QPoint(size.width() / 2, size.height() / 2));
    cursor_ = QPoint(std::clamp(from.x() + by.x(), 0, size.width() - 1),
                     std::clamp(from.y() + by.y(), 0, size.height() - 1));
    picture_->view().setCursorAt(QPointF((cursor_->x() + 0.5) / size.width() * film().width(),
                                         (cursor_->y() + 0.5) / size.height() * film().height()));
    showInkAt(cursor_);
}

bool PlatesDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &picture_->view() && event->type() == QEvent::KeyPress && separation_) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const int step = key->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
        const QMap<int, QPoint> ways{{Qt::Key_Left, {-step, 0}},
                                     {Qt::Key_Right, {step, 0}},
                                     {Qt::Key_Up, {0, -step}},
                                     {Qt::Key_Down, {0, step}}};
        if (key->modifiers().testFlag(Qt::ControlModifier) && ways.contains(key->key())) {
            moveCursor(ways[key->key()]);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void PlatesDialog::fail(std::exception_ptr failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        figures_->setText(error.sentence());
    } catch (const std::exception& error) {
        figures_->setText(QString::fromUtf8(error.what()));
    }
}

} // namespace dipwright
