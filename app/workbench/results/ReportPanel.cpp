#include "workbench/results/ReportPanel.h"

#include "base/NumberText.h"
#include "cost/CostText.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/SmallerFilm.h"
#include "texture/ReverseTexture.h"
#include "traveller/TankTasks.h"
#include "workbench/results/WarningTexts.h"
#include "workbench/widgets/HtmlView.h"
#include "workbench/widgets/ShippedNames.h"

#include <QCoreApplication>
#include <QLabel>
#include <QLocale>
#include <QTextBlock>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <span>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ReportPanel)
};

constexpr std::size_t mostPlaces = 8;                 // unreached places that are listed one by one
const QString placeScheme = QStringLiteral("place:"); // marks a link to a place of the model

const QString inkScheme = QStringLiteral("ink:"); // marks a link to an option for ink

class Table {
public:
    void row(const QString& name, const QString& value) {
        htmlRow(name.toHtmlEscaped(), value.toHtmlEscaped());
    }
    void htmlRow(const QString& name, const QString& value) {
        html_ += QStringLiteral("<tr><td style='padding:3px 16px 3px 0'>%1</td>"
                                "<td style='padding:3px 0' align='right'>%2</td></tr>")
                     .arg(name, value);
    }
    void row(const CostRow& row) {
        html_ += QStringLiteral("<tr>");
        for (const QString& cell : {row.what, row.amount, row.cost}) {
            html_ += QStringLiteral("<td style='padding:3px 12px 3px 0' align='%1'>%2</td>")
                         .arg(cell == row.what ? QStringLiteral("left") : QStringLiteral("right"),
                              cell.toHtmlEscaped());
        }
        html_ += QStringLiteral("</tr>");
    }
    QString html() const {
        return QStringLiteral("<table width='100%' cellspacing='0'>%1</table>").arg(html_);
    }

private:
    QString html_;
};

QString heading(const QString& text) {
    return QStringLiteral("<h3 style='margin-bottom:4px'>%1</h3>").arg(text.toHtmlEscaped());
}

QString percent(double share) {
    return Text::tr("%1 %").arg(numberText(share * 100, 1));
}

// Links places of the model, and collects them.
class PlaceLinks {
public:
    explicit PlaceLinks(LengthUnit unit) : unit_(unit) {}

    QString html(const Eigen::Vector3f& place) {
        places_.push_back(place);
        return QStringLiteral("<a href='%1%2'>%3</a>")
            .arg(placeScheme, QString::number(places_.size() - 1),
                 Text::tr("%1 on the model").arg(shownPlace(place, unit_)).toHtmlEscaped());
    }
    const std::vector<Eigen::Vector3f>& places() const { return places_; }

private:
    LengthUnit unit_;
    std::vector<Eigen::Vector3f> places_;
};

// The value that this share of the values does not exceed.
double percentile(std::vector<float> values, double share) {
    if (values.empty()) {
        return 0;
    }
    const auto rank = std::ptrdiff_t(std::ceil(share * double(values.size()))) - 1;
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return double(values[std::size_t(rank)]);
}

// Returns the middle of the film's most stretched side on the body, in model coordinates. `largest`
// is its stretch.
std::optional<Eigen::Vector3f> placeOfLargestStretch(const LaidFilm& laid, double largest) {
    const DippedFilm& film = laid.film();
    const auto columns = std::size_t(film.grid.columns), rows = std::size_t(film.grid.rows);
    const std::vector<float> stretches = constraintStretches(film);
    const std::vector<std::uint8_t>& isPainted = laid.painted().points;
    for (std::size_t side = 0; side < stretches.size(); ++side) {
        const std::size_t firstVertical = rows * (columns - 1);
        const bool isHorizontal = side < firstVertical;
        const std::size_t from = isHorizontal
                                     ? side / (columns - 1) * columns + side % (columns - 1)
                                     : side - firstVertical;
        const std::size_t to = from + (isHorizontal ? 1 : columns);
        if (double(stretches[side]) == largest && isPainted[from] != 0 && isPainted[to] != 0) {
            const Eigen::Vector3f middle = (film.positions[from] + film.positions[to]) / 2;
            return (laid.body().modelToPose.inverse() * middle.cast<double>()).cast<float>();
        }
    }
    return std::nullopt; // no film on the body
}

QString warningAnchor(std::size_t number) {
    return QStringLiteral("warning-%1").arg(number);
}

QString warningsHtml(const std::vector<JobWarning>& warnings, const JobResult& result,
                     LengthUnit unit, PlaceLinks& links) {
    Table table;
    for (std::size_t number = 0; number < warnings.size(); ++number) {
        table.htmlRow(QStringLiteral("<a name='%1'></a>%2")
                          .arg(warningAnchor(number),
                               warningText(warnings[number], result, unit).toHtmlEscaped()),
                      links.html(warnings[number].place));
    }
    return heading(Text::tr("Warnings on the part")) + table.html();
}

QString shareHtml(const JobResult& result, LengthUnit unit, PlaceLinks& links) {
    const BodyShare& share = *result.share;
    const auto area = [&](double squareMillimetres) {
        return QStringLiteral("%1 · %2").arg(shownArea(squareMillimetres, unit),
                                             percent(squareMillimetres / share.areas.total()));
    };
    Table table;
    table.row(Text::tr("Painted by %1 only").arg(result.immersions[0].immersion.name),
              area(share.areas.first));
    table.row(Text::tr("Painted by %1 only").arg(result.immersions[1].immersion.name),
              area(share.areas.second));
    table.row(Text::tr("Overlap, painted by both"), area(share.areas.both));
    table.row(Text::tr("Reached by neither dip"), area(share.areas.none));
    table.row(Text::tr("Width of the overlap"), Text::tr("%1 to %2")
                                                    .arg(shownLength(share.overlap.least, unit),
                                                         shownLength(share.overlap.most, unit)));
    table.row(Text::tr("Overlap too narrow for a registration error of %1")
                  .arg(shownLength(result.project.share.registrationError.value(), unit)),
              percent(share.narrow));
    table.row(Text::tr("Length of the seam"), shownLength(share.cost.length, unit));
    const std::vector<UnpaintedPlace> unpainted = unreachedPlaces(result);
    const std::size_t listed = std::min(unpainted.size(), mostPlaces);
    for (const UnpaintedPlace& place : std::span(unpainted).first(listed)) {
        table.htmlRow(
            Text::tr("Area not reached, at %1").toHtmlEscaped().arg(links.html(place.place)),
            shownArea(place.area, unit).toHtmlEscaped());
    }
    if (listed < unpainted.size()) {
        table.row(Text::tr("Number of smaller areas not reached"),
                  QLocale().toString(qulonglong(unpainted.size() - listed)));
    }
    return heading(Text::tr("Seam")) + table.html();
}

QString immersionHtml(const ImmersionResult& result, LengthUnit unit, PlaceLinks& links) {
    const DippedFilm& film = result.laid->film();
    const Distribution stretch = distribution(result.laid->painted().constraints);
    const Distribution area = distribution(result.laid->painted().areas);
    std::size_t adhered = 0;
    for (std::size_t point = 0; point < film.states.size(); ++point) {
        adhered += film.adhered(point);
    }
    const QLocale locale;
    Table table;
    table.row(Text::tr("Coverage"), percent(result.coverage->share));
    const Coverage& coverage = *result.coverage;
    table.row(
        Text::tr("Area painted by film that tore, was released or did not converge"),
        QStringLiteral("%1 · %2").arg(
            shownArea(coverage.marked.any, unit),
            percent(coverage.paintedArea > 0 ? coverage.marked.any / coverage.paintedArea : 0)));
    for (const solver::PointMark mark : filmMarks) {
        if (coverage.marked.of(mark) > 0) {
            table.row(markText(mark), shownArea(coverage.marked.of(mark), unit));
        }
    }
    table.row(Text::tr("Smallest film cell"), shownLength(film.grid.leastSpacing(), unit));
    table.row(Text::tr("Film points on the part"),
              Text::tr("%1 of %2")
                  .arg(locale.toString(qulonglong(adhered)),
                       locale.toString(qulonglong(film.states.size()))));
    table.row(Text::tr("Stretch: mean, 99 % below, largest"),
              QStringLiteral("%1 · %2 · %3")
                  .arg(numberText(stretch.mean, 3),
                       numberText(percentile(result.laid->painted().constraints, 0.99), 3),
                       numberText(stretch.maximum, 3)));
    if (const auto place = placeOfLargestStretch(*result.laid, stretch.maximum)) {
        table.htmlRow(Text::tr("Place of the largest stretch").toHtmlEscaped(), links.html(*place));
    }
    table.row(
        Text::tr("Area stretch, smallest and largest"),
        QStringLiteral("%1 · %2").arg(numberText(area.minimum, 3), numberText(area.maximum, 3)));
    if (result.readBack) {
        table.row(Text::tr("Read-back error, mean and 95 %"),
                  QStringLiteral("%1 · %2").arg(shownLength(result.readBack->mean, unit),
                                                shownLength(result.readBack->percentile95, unit)));
    }
    table.row(Text::tr("Film triangles across texture seams"),
              locale.toString(qulonglong(result.texture->seamTriangles)));
    table.row(Text::tr("Area too pale because of the ink limit"),
              shownArea(result.inkShortfall.value_or(result.texture->shortfallArea), unit));
    table.row(Text::tr("Trapped air"), shownArea(result.coverage->trappedAir.area, unit));
    table.row(Text::tr("Simulation time"), Text::tr("%1 s").arg(numberText(film.wallSeconds, 2)));
    table.row(Text::tr("Steps"), locale.toString(qlonglong(film.steps)));
    table.row(Text::tr("Steps that did not converge"),
              locale.toString(qlonglong(film.equilibrium.stepsWithout)));
    return heading(result.immersion.name) + table.html();
}

constexpr int inkColumns = 5;

QString inkRow(const QStringList& values) {
    QString html = QStringLiteral("<tr>");
    for (const QString& value : values) {
        html += QStringLiteral("<td style='padding:0 0 6px 8px' align='right'>%1</td>")
                    .arg(value.toHtmlEscaped());
    }
    return html + QStringLiteral("</tr>");
}

// A row of its own, because names of options are long and the page is narrow.
QString inkTitle(const QString& html) {
    return QStringLiteral("<tr><td colspan='%1' style='padding:3px 0'>%2</td></tr>")
        .arg(inkColumns)
        .arg(html);
}

QString inkValues(const InkReach& reach) {
    return inkRow({Text::tr("%1 %").arg(numberText(100 * reach.shortShare, 2)),
                   numberText(reach.missing95, 2), numberText(reach.mostMissing, 2),
                   std::isnan(reach.contrast)
                       ? QStringLiteral("–")
                       : Text::tr("%1 %").arg(numberText(100 * reach.contrast, 0)),
                   numberText(reach.colourError, 1)});
}

QString inkOptionsHtml(const InkOptions& found) {
    QString rows =
        inkRow({Text::tr("Too pale"), Text::tr("Missing, 95 %"), Text::tr("Missing, most"),
                Text::tr("Contrast"), Text::tr("Colour error ΔE")}) +
        inkTitle(Text::tr("Now").toHtmlEscaped()) + inkValues(found.now);
    for (std::size_t i = 0; i < found.options.size(); ++i) {
        const InkOption& option = found.options[i];
        const QString link =
            QStringLiteral("<a href='%1%2'>%3</a>")
                .arg(inkScheme, QString::number(i), remedyText(option).toHtmlEscaped());
        rows +=
            option.reach
                ? inkTitle(link) + inkValues(*option.reach)
                : inkTitle(QStringLiteral("%1: %2").arg(link, optionText(option).toHtmlEscaped()));
    }
    return heading(Text::tr("Where ink does not suffice")) +
           QStringLiteral("<p>%1</p><table width='100%' cellspacing='0'>%2</table>")
               .arg(
                   Text::tr("A click on an option changes the project; it can be undone. Too pale: "
                            "share of the painted surface. Missing: optical density where ink is "
                            "short now (95 %), and the most anywhere. Contrast: of the texture, "
                            "where ink is short now. Colour error: mean difference to the texture "
                            "on the painted surface.")
                       .toHtmlEscaped(),
                   rows);
}

QString costHtml(const std::vector<OrderCost>& costs) {
    QString html = heading(Text::tr("Cost and time"));
    for (const OrderCost& cost : costs) {
        const QString parts =
            cost.parts == 1 ? Text::tr("One part") : Text::tr("Order of %1 parts").arg(cost.parts);
        html += QStringLiteral("<p><b>%1</b></p>").arg(parts.toHtmlEscaped());
        Table table;
        for (const CostRow& row : costRows(cost)) {
            table.row(row);
        }
        for (const CostRow& row : timeRows(cost)) {
            table.row(row);
        }
        table.row(CostRow{Text::tr("Sheets to print"), QLocale().toString(cost.sheets), {}});
        html += table.html();
    }
    if (costs.front().areInksEstimated) {
        html += QStringLiteral("<p>%1</p>")
                    .arg(Text::tr("The amounts of ink are estimated, because the project has no "
                                  "printer profile with an ICC profile in CMYK.")
                             .toHtmlEscaped());
    }
    return html + QStringLiteral("<p><a href='cost-table'>%1</a> · <a href='prices'>%2</a></p>")
                      .arg(Text::tr("Save as CSV…").toHtmlEscaped(),
                           Text::tr("Edit prices…").toHtmlEscaped());
}

QString tankHtml(const std::vector<TankTime>& times) {
    Table table;
    table.row(CostRow{Text::tr("Step"), Text::tr("Planned"), Text::tr("Took, mean of all runs")});
    for (const TankSummary& step : tankSummaries(times)) {
        table.row(CostRow{Text::tr("Dip %1: %2").arg(step.dip).arg(tankStepTitle(step.step)),
                          step.planned ? durationText(*step.planned) : QString(),
                          Text::tr("%1 (%2 to %3)")
                              .arg(durationText(step.mean), durationText(step.shortest),
                                   durationText(step.longest))});
    }
    return heading(Text::tr("At the tank")) + table.html();
}

// Empty if no smaller film is large enough.
QString smallerFilmHtml(const JobResult& result, LengthUnit unit) {
    const std::optional<SmallerFilm> smaller = smallerFilm(result);
    if (!smaller) {
        return {};
    }
    constexpr int fewer = -2; // fewer decimals: the size of a format is known exactly
    return QStringLiteral("<p>%1 <a href='smaller-film'>%2</a></p>")
        .arg(
            Text::tr("Most of the film stays empty. A film of format %1 (%2 × %3) is large enough.")
                .arg(smaller->format, shownLength(smaller->width.value(), unit, fewer),
                     shownLength(smaller->height.value(), unit, fewer))
                .toHtmlEscaped(),
            Text::tr("Use this film").toHtmlEscaped());
}

} // namespace

ReportPanel::ReportPanel(QWidget* parent)
    : QWidget(parent), text_(new HtmlView),
      hint_(new QLabel(tr("Run the dip to see its figures."))) {
    text_->setFrameShape(QFrame::NoFrame);
    text_->setObjectName(QStringLiteral("report"));
    text_->setAccessibleName(tr("Report"));
    text_->setOpenLinks(false);
    connect(text_, &HtmlView::anchorClicked, this, &ReportPanel::follow);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setWordWrap(true);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(text_);
    layout->addWidget(hint_);
    text_->hide();
}

void ReportPanel::setResult(std::shared_ptr<const JobResult> result,
                            std::vector<JobWarning> warnings, std::optional<InkOptions> inkOptions,
                            LengthUnit unit) {
    result_ = std::move(result);
    warnings_ = std::move(warnings);
    inkOptions_ = std::move(inkOptions);
    unit_ = unit;
    show();
}

void ReportPanel::setTolerances(const QStringList& sentences) {
    if (sentences != tolerances_) {
        tolerances_ = sentences;
        show();
    }
}

void ReportPanel::setCosts(const std::vector<OrderCost>& costs) {
    if (costs != costs_) {
        costs_ = costs;
        show();
    }
}

void ReportPanel::setTankTimes(const std::vector<TankTime>& times) {
    if (times != tankTimes_) {
        tankTimes_ = times;
        show();
    }
}

void ReportPanel::showWarning(std::size_t number) {
    const QString anchor = warningAnchor(number);
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            if (part.fragment().charFormat().anchorNames().contains(anchor)) {
                QTextCursor cursor(block);
                cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
                text_->setTextCursor(cursor);
                text_->ensureCursorVisible();
                return;
            }
        }
    }
}

void ReportPanel::show() {
    text_->setVisible(result_ != nullptr);
    hint_->setVisible(!result_);
    if (!result_) {
        return;
    }
    PlaceLinks links(unit_);
    Table whole;
    whole.row(tr("Total coverage"), percent(result_->coverageTotal));
    if (result_->mask) {
        if (result_->mask != mask_) {
            mask_ = result_->mask;
            masked_ = maskedAreas(*mask_);
        }
        whole.row(tr("Masked areas"),
                  QStringLiteral("%1 · %2").arg(masked_.count).arg(shownArea(masked_.area, unit_)));
    }
    whole.row(tr("Film used"), percent(filmUsed(*result_)));
    whole.row(tr("Solver"), shownName(result_->solver.name));
    whole.row(tr("Device"), result_->solver.device);
    QString html = whole.html() + smallerFilmHtml(*result_, unit_);
    for (const QString& note : result_->notes) {
        html += QStringLiteral("<p><b>%1</b></p>").arg(note.toHtmlEscaped());
    }
    if (!warnings_.empty()) {
        html += warningsHtml(warnings_, *result_, unit_, links);
    }
    if (inkOptions_) {
        html += inkOptionsHtml(*inkOptions_);
    }
    if (result_->share) {
        html += shareHtml(*result_, unit_, links);
    }
    if (!tolerances_.isEmpty()) {
        html += heading(tr("Tolerances"));
    }
    for (const QString& sentence : tolerances_) {
        html += QStringLiteral("<p>%1</p>").arg(sentence.toHtmlEscaped());
    }
    for (const ImmersionResult& immersion : result_->immersions) {
        html += immersionHtml(immersion, unit_, links);
    }
    if (!costs_.empty()) {
        html += costHtml(costs_);
    }
    if (!tankTimes_.empty()) {
        html += tankHtml(tankTimes_);
    }
    places_ = links.places();
    text_->showHtml(html);
}

void ReportPanel::follow(const QUrl& link) {
    const QString target = link.toString();
    if (target == QLatin1String("cost-table")) {
        emit costTableAsked();
        return;
    }
    if (target == QLatin1String("prices")) {
        emit pricesAsked();
        return;
    }
    if (target.startsWith(inkScheme)) {
        const std::size_t number = target.mid(inkScheme.size()).toULong();
        if (inkOptions_ && number < inkOptions_->options.size()) {
            emit inkOptionTaken(inkOptions_->options[number]);
        }
        return;
    }
    if (!target.startsWith(placeScheme)) {
        emit smallerFilmTaken();
        return;
    }
    const std::size_t number = target.mid(placeScheme.size()).toULong();
    if (number < places_.size()) {
        emit placeChosen(places_[number]);
    }
}

} // namespace dipwright
