#include "workbench/accuracy/VerdictPanel.h"

#include "pipeline/JobVerdict.h"
#include "results/Results.h"
#include "workbench/widgets/HtmlView.h"
#include "workbench/widgets/PicturePanel.h"

#include <QCoreApplication>
#include <QLocale>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(VerdictPanel)
};

constexpr double mapPixelsPerMillimetre = 5; // sets the map's size on the screen
constexpr int mapEdge = 1600;                // pixels
constexpr int shownPlaces = 5;
const QString fieldScheme = QStringLiteral("field:"); // marks a link to a field of the project
constexpr double mostText = 0.65; // share of the panel's height; longer text scrolls

// Returns the colour of the band beside the text. It is readable on light and dark windows. The
// colours differ with any colour vision.
QString colourOf(Advice advice) {
    switch (advice) {
    case Advice::Print:
        return QStringLiteral("#008a9a");
    case Advice::CheckFirst:
        return QStringLiteral("#c88000");
    case Advice::DoNotPrint:
        return QStringLiteral("#d2304f");
    case Advice::NotJudged:
        break;
    }
    return QStringLiteral("#808080");
}

QString paragraph(const QString& text) {
    return QStringLiteral("<p style='margin:4px 0'>%1</p>")
        .arg(withUnitsKept(text).toHtmlEscaped());
}

QString placeHtml(const PlaceToCheck& place, std::size_t number, LengthUnit unit) {
    const QString words = placeText(
        place, [unit](double length) { return shownLength(length, unit); },
        [unit](double area) { return shownArea(area, unit); });
    return QStringLiteral("<li><a href='%1'>%2</a></li>")
        .arg(QString::number(number), withUnitsKept(words).toHtmlEscaped());
}

// Returns the reason's sentence, with a link to the setting that holds its limit, if there is one.
QString reasonHtml(const JobReason& reason, const JobResult& result, const QString& colour,
                   LengthUnit unit) {
    JobReason shown = reason;
    if (result.immersions.size() == 1) {
        shown.dip.reset();
    }
    const auto length = [unit](double millimetres) { return shownLength(millimetres, unit); };
    QString words = paragraph(QStringLiteral("■ ") + reasonText(shown, result, length));
    words.replace(QStringLiteral("■"),
                  QStringLiteral("<span style='color:%1'>■</span>").arg(colour));
    if (const QString field = limitField(reason.reason.kind); !field.isEmpty()) {
        words.insert(words.lastIndexOf(QLatin1String("</p>")),
                     QStringLiteral(" <a href='%1%2'>%3</a>")
                         .arg(fieldScheme, field, Text::tr("Setting").toHtmlEscaped()));
    }
    return words;
}

// Returns large, bold text.
QString title(const QString& text) {
    return QStringLiteral("<b style='font-size:large'>%1</b>").arg(text.toHtmlEscaped());
}

// A verdict that is not `fresh` is grey, below a title that says so.
QString html(const JobResult& result, const ImmersionResult& dip, bool fresh, LengthUnit unit) {
    const auto colour = [fresh](Advice advice) {
        return colourOf(fresh ? advice : Advice::NotJudged);
    };
    const Advice advice = adviceOf(result);
    QString words;
    if (!fresh) {
        words = QStringLiteral("<p style='margin:4px 0'>%1</p>")
                    .arg(title(Text::tr("Before the last changes")));
    }
    words += QStringLiteral("<table cellspacing='0' cellpadding='4'><tr><td width='6' "
                            "bgcolor='%1'></td><td>%2</td></tr></table>")
                 .arg(colour(advice),
                      fresh ? title(adviceText(advice)) : adviceText(advice).toHtmlEscaped());
    for (const JobReason& reason : reasonsOf(result)) {
        words += reasonHtml(reason, result, colour(reason.reason.advice), unit);
    }
    const Verdict& verdict = dip.verdict;
    if (verdict.advice > Advice::Print && !verdict.places.empty()) {
        words += paragraph(Text::tr("Places to check in %1:").arg(dip.immersion.name));
        words += QStringLiteral("<ol style='margin:2px 0'>");
        for (std::size_t n = 0; n < std::min<std::size_t>(verdict.places.size(), shownPlaces);
             ++n) {
            words += placeHtml(verdict.places[n], n, unit);
        }
        words += QStringLiteral("</ol>");
    }
    const Coverage& coverage = *dip.coverage;
    return words + paragraph(markedText(coverage.marked, coverage.paintedArea));
}

QString draftText(DraftEnd end) {
    switch (end) {
    case DraftEnd::Cancelled:
        return VerdictPanel::tr("This is a draft. There is no verdict, because the run was "
                                "cancelled. Run the dip to get one.");
    case DraftEnd::Failed:
        return VerdictPanel::tr("This is a draft. There is no verdict, because the run failed. See "
                                "the log for the reason, then run the dip again.");
    case DraftEnd::ResultFollows:
        break;
    }
    return VerdictPanel::tr("This is a draft. The verdict follows with the result.");
}

} // namespace

VerdictPanel::VerdictPanel(QWidget* parent)
    : QWidget(parent), text_(new HtmlView),
      map_(new PicturePanel(tr("Numerical error of the sheet"),
                            tr("Run the dip to see the numerical error of the sheet."))) {
    text_->setFrameShape(QFrame::NoFrame);
    text_->setObjectName(QStringLiteral("verdict"));
    text_->setAccessibleName(tr("Verdict"));
    text_->setOpenLinks(false);
    text_->hide();
    connect(text_, &HtmlView::anchorClicked, this, &VerdictPanel::choosePlace);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSizeConstraint(QLayout::SetNoConstraint);
    layout->addWidget(text_);
    layout->addWidget(map_, 1);
}

void VerdictPanel::setOutcome(const DipOutcome& outcome, std::size_t immersion, LengthUnit unit) {
    const bool isThere = outcome.result && immersion < outcome.result->immersions.size();
    result_ = isThere ? outcome.result : nullptr;
    immersion_ = immersion;
    isDraft_ = outcome.fineness.isDraft();
    unit_ = unit;
    text_->setVisible(isThere);
    map_->setVisible(!isDraft_);
    map_->clear();
    if (!isThere) {
        return;
    }
    const ImmersionResult& result = result_->immersions[immersion];
    places_ = result.verdict.places;
    if (const NumericalErrorEstimate* estimate = result.knownError()) {
        const QImage map = numericalErrorMap(
            *result.laid, estimate->pointErrors,
            allowedError(Zone::C, outcome.result->project.tolerance), mapEdge, unit);
        map_->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
    }
    showText();
}

void VerdictPanel::setFresh(bool fresh) {
    if (std::exchange(isFresh_, fresh) != fresh) {
        showText();
    }
}

void VerdictPanel::setDraftEnd(DraftEnd end) {
    if (std::exchange(draftEnd_, end) != end) {
        showText();
    }
}

void VerdictPanel::showText() {
    if (!result_) {
        return;
    }
    text_->showHtml(isDraft_ ? paragraph(draftText(draftEnd_))
                             : html(*result_, result_->immersions[immersion_], isFresh_, unit_));
    fitText();
}

// The height of the text follows that of the panel, not the other way round.
QSize VerdictPanel::minimumSizeHint() const {
    constexpr int leastText = 80; // pixels
    return {QWidget::minimumSizeHint().width(), map_->minimumSizeHint().height() + leastText};
}

void VerdictPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitText();
}

// Returns the height of the map at the panel's width, with its buttons; 0 while it is hidden.
int VerdictPanel::wantedMapHeight() const {
    if (map_->isHidden()) {
        return 0;
    }
    const PictureView& view = map_->view();
    const int least = map_->minimumSizeHint().height();
    const QSize picture = view.picture().size();
    return picture.isEmpty() ? least
                             : least - view.minimumSizeHint().height() +
                                   picture.scaled(width(), height(), Qt::KeepAspectRatio).height();
}

// Makes the text field as tall as its text, but leaves the map the height that it fills at the
// panel's width, up to a share of the panel's height. Measures a copy, because a scroll bar changes
// the line breaks of the original.
void VerdictPanel::fitText() {
    const QMargins around = layout()->contentsMargins();
    const std::unique_ptr<QTextDocument> measured(text_->document()->clone());
    measured->setTextWidth(width() - around.left() - around.right());
    const int words = int(std::ceil(measured->size().height()));
    const int free = height() - around.top() - around.bottom() - layout()->spacing();
    const int most = std::max(int(mostText * height()), free - wantedMapHeight());
    text_->setVerticalScrollBarPolicy(words > most ? Qt::ScrollBarAlwaysOn
                                                   : Qt::ScrollBarAlwaysOff);
    text_->setFixedHeight(std::min(words, most));
}

void VerdictPanel::choosePlace(const QUrl& link) {
    const QString target = link.toString();
    if (target.startsWith(fieldScheme)) {
        emit fieldChosen(target.mid(fieldScheme.size()));
        return;
    }
    const std::size_t number = target.toULong();
    if (number < places_.size()) {
        emit placeChosen(places_[number].rest);
    }
}

} // namespace dipwright
