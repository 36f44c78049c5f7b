#include "workbench/poses/MeasurePlot.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {

namespace {

constexpr int margin = 10;   // pixels
constexpr int textGap = 4;   // pixels between the values and the frame
constexpr double dot = 4;    // radius in pixels
constexpr double reach = 10; // pixels around a dot that count as the dot

// The measure with the sign that makes larger values better.
double goodness(const RankedPoses& poses, Measure measure) {
    const double value = poses.measures[measure];
    return isHigherBetter(measure) ? value : -value;
}

} // namespace

std::vector<std::size_t> paretoOptimalRanks(const std::vector<RankedPoses>& ranking, Measure one,
                                            Measure other) {
    std::vector<std::size_t> best;
    for (std::size_t rank = 0; rank < ranking.size(); ++rank) {
        const double x = goodness(ranking[rank], one), y = goodness(ranking[rank], other);
        const bool isBeaten =
            std::any_of(ranking.begin(), ranking.end(), [&](const RankedPoses& rival) {
                const double a = goodness(rival, one), b = goodness(rival, other);
                return a >= x && b >= y && (a > x || b > y);
            });
        if (!isBeaten) {
            best.push_back(rank);
        }
    }
    return best;
}

// The dots: better is to the right and up.
class MeasurePlot::Field : public QWidget {
public:
    explicit Field(MeasurePlot& plot) : QWidget(&plot), plot_(plot) {
        setObjectName(QStringLiteral("measurePlot"));
        setMinimumHeight(110);
    }

    // `across` and `up`: the worst and the best value on each axis.
    void set(std::vector<QPointF> values, std::vector<std::size_t> best,
             const std::array<QString, 2>& across, const std::array<QString, 2>& up) {
        values_ = std::move(values);
        across_ = across;
        up_ = up;
        best_ = std::move(best);
        update();
    }
    void setChosen(const std::vector<std::size_t>& ranks) {
        chosen_ = ranks;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(palette().color(QPalette::Mid));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRect(QRectF(frame()).adjusted(0.5, 0.5, -0.5, -0.5));
        drawAxes(painter);
        QPolygonF line;
        for (const std::size_t rank : best_) {
            line << placeOf(rank);
        }
        std::sort(line.begin(), line.end(),
                  [](QPointF one, QPointF other) { return one.x() < other.x(); });
        const QColor blue = palette().color(QPalette::Active, QPalette::Highlight);
        painter.setPen(QPen(blue, 1, Qt::DashLine));
        painter.drawPolyline(line);
        for (std::size_t rank = 0; rank < values_.size(); ++rank) {
            const bool isBest = std::find(best_.begin(), best_.end(), rank) != best_.end();
            painter.setPen(Qt::NoPen);
            painter.setBrush(isBest ? blue : palette().color(QPalette::Mid));
            painter.drawEllipse(placeOf(rank), dot, dot);
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Text), 2));
        for (const std::size_t rank : chosen_) {
            if (rank < values_.size()) {
                painter.drawEllipse(placeOf(rank), dot + 3, dot + 3);
            }
        }
    }
    void mousePressEvent(QMouseEvent* event) override {
        if (const auto rank = rankAt(event->position())) {
            emit plot_.picked(*rank);
        }
    }
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ToolTip) {
            auto& help = static_cast<QHelpEvent&>(*event);
            if (const auto rank = rankAt(help.pos())) {
                QToolTip::showText(help.globalPos(), plot_.textOf(*rank), this);
                return true;
            }
        }
        return QWidget::event(event);
    }

private:
    QPointF placeOf(std::size_t rank) const {
        QRectF box(values_.front(), values_.front());
        for (const QPointF value : values_) {
            box.setLeft(std::min(box.left(), value.x()));
            box.setRight(std::max(box.right(), value.x()));
            box.setTop(std::min(box.top(), value.y()));
            box.setBottom(std::max(box.bottom(), value.y()));
        }
        const auto within = [](double value, double least, double most) {
            return most > least ? (value - least) / (most - least) : 0.5;
        };
        const double x = within(values_[rank].x(), box.left(), box.right());
        const double y = within(values_[rank].y(), box.top(), box.bottom());
        const QRect inner = frame().adjusted(margin, margin, -margin, -margin);
        return {inner.left() + x * inner.width(), inner.bottom() - y * inner.height()};
    }
    // The frame around the dots, with room for the values of the axes to the left and below.
    QRect frame() const {
        const int left = std::max(fontMetrics().horizontalAdvance(up_[0]),
                                  fontMetrics().horizontalAdvance(up_[1]));
        const bool hasValues = !values_.empty();
        return rect().adjusted(hasValues ? left + textGap : 0, 0, 0,
                               hasValues ? -fontMetrics().height() - textGap : 0);
    }
    void drawAxes(QPainter& painter) const {
        if (values_.empty()) {
            return;
        }
        const QRect box = frame();
        const QRect left(0, box.top(), box.left() - textGap, box.height());
        const QRect below(box.left(), box.bottom() + textGap, box.width(), fontMetrics().height());
        painter.save();
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(left, Qt::AlignRight | Qt::AlignTop, up_[1]);
        painter.drawText(left, Qt::AlignRight | Qt::AlignBottom, up_[0]);
        painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, across_[0]);
        painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, across_[1]);
        const int taken = fontMetrics().horizontalAdvance(across_[0]) +
                          fontMetrics().horizontalAdvance(across_[1]);
        const QString better = MeasurePlot::tr("better →");
        if (taken + fontMetrics().horizontalAdvance(better) + 4 * textGap < below.width()) {
            painter.drawText(below, Qt::AlignCenter, better);
        }
        painter.restore();
    }
    std::optional<std::size_t> rankAt(QPointF place) const {
        std::optional<std::size_t> nearest;
        double least = reach;
        for (std::size_t rank = 0; rank < values_.size(); ++rank) {
            const QPointF away = placeOf(rank) - place;
            if (const double distance = std::hypot(away.x(), away.y()); distance < least) {
                least = distance;
                nearest = rank;
            }
        }
        return nearest;
    }

    MeasurePlot& plot_;
    std::vector<QPointF> values_; // one for each rank; larger is better
    std::vector<std::size_t> best_, chosen_;
    std::array<QString, 2> across_, up_; // the worst and the best value on each axis
};

MeasurePlot::MeasurePlot(QWidget* parent)
    : QWidget(parent), across_(makeChoice(Measure::Coverage, tr("Horizontal axis"))),
      up_(makeChoice(Measure::Stretch, tr("Vertical axis"))), field_(new Field(*this)) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(up_, 0, 0);
    layout->addWidget(field_, 1, 0);
    layout->addWidget(across_, 2, 0, Qt::AlignRight);
    layout->setRowStretch(1, 1);
    draw();
}

QComboBox* MeasurePlot::makeChoice(Measure measure, const QString& name) {
    auto* choice = new QComboBox;
    for (const Measure each : allMeasures()) {
        choice->addItem(measureName(each), int(each));
    }
    choice->setCurrentIndex(choice->findData(int(measure)));
    choice->setAccessibleName(name);
    choice->setToolTip(tr("Right and up is better. The line joins the poses that no other pose "
                          "beats in both measures."));
    connect(choice, &QComboBox::currentIndexChanged, this, &MeasurePlot::draw);
    return choice;
}

void MeasurePlot::setRanking(const std::vector<RankedPoses>& ranking) {
    ranking_ = ranking;
    draw();
}

void MeasurePlot::setChosen(const std::vector<std::size_t>& ranks) {
    field_->setChosen(ranks);
}

QString MeasurePlot::textOf(std::size_t rank) const {
    const auto line = [&](const QComboBox& choice) {
        const auto measure = Measure(choice.currentData().toInt());
        return tr("%1: %2").arg(measureName(measure),
                                measureText(measure, ranking_[rank].measures[measure]));
    };
    return tr("Rank %1").arg(rank + 1) + QLatin1Char('\n') + line(*across_) + QLatin1Char('\n') +
           line(*up_);
}

void MeasurePlot::draw() {
    const auto across = Measure(across_->currentData().toInt());
    const auto up = Measure(up_->currentData().toInt());
    std::vector<QPointF> values;
    for (const RankedPoses& poses : ranking_) {
        values.emplace_back(goodness(poses, across), goodness(poses, up));
    }
    const auto ends = [this](Measure measure) -> std::array<QString, 2> {
        if (ranking_.empty()) {
            return {};
        }
        const auto [worst, best] = std::minmax_element(
            ranking_.begin(), ranking_.end(), [measure](const auto& one, const auto& other) {
                return goodness(one, measure) < goodness(other, measure);
            });
        return {measureText(measure, worst->measures[measure]),
                measureText(measure, best->measures[measure])};
    };
    const auto acrossEnds = ends(across), upEnds = ends(up);
    const auto words = [](Measure measure, const std::array<QString, 2>& shown) {
        return tr("%1: worst %2, best %3").arg(measureName(measure), shown[0], shown[1]);
    };
    field_->setAccessibleDescription(ranking_.empty() ? QString()
                                                      : words(across, acrossEnds) +
                                                            QLatin1Char('\n') + words(up, upEnds));
    field_->set(std::move(values), paretoOptimalRanks(ranking_, across, up), acrossEnds, upEnds);
}

} // namespace dipwright
