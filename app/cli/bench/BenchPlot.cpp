// Draws the paper's Figures 6 and 7 with measured rates: steps per second, by number of constraints
// and by field resolution.

#include "base/Png.h"
#include "cli/bench/BenchReport.h"
#include "disk/AtomicFile.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>

#include <array>
#include <cmath>
#include <limits>

namespace dipwright::cli {
namespace {

constexpr QSize plotSize(1400, 640);

// Colours that colour-blind readers can distinguish (after Okabe and Ito).
const std::array<QColor, 3> seriesColours{QColor(0, 114, 178), QColor(213, 94, 0),
                                          QColor(0, 158, 115)};
const QColor paperColour(70, 70, 70);

// Maps numbers to positions along one side of a plot, on a linear or logarithmic scale.
struct Scale {
    bool isLogarithmic = true;
    double first = 1, last = 10; // the numbers at the ends
    std::vector<double> ticks;

    // Returns the position of `value` between `begin` and `end`.
    double place(double value, double begin, double end) const {
        return begin + (end - begin) * (along(value) - along(first)) / (along(last) - along(first));
    }

private:
    double along(double value) const { return isLogarithmic ? std::log10(value) : value; }
};

double powerOfTenBelow(double value) {
    return std::pow(10, std::floor(std::log10(value)));
}

// Returns a scale that is extended to whole powers of ten.
Scale logarithmicScale(double low, double high) {
    Scale scale{true, powerOfTenBelow(low), 10 * powerOfTenBelow(high), {}};
    const int decades = int(std::lround(std::log10(scale.last / scale.first)));
    for (int decade = 0; decade <= decades; ++decade) {
        scale.ticks.push_back(scale.first * std::pow(10, decade));
    }
    return scale;
}

// Returns a scale from 0 with 4 to 10 steps of 1, 2 or 5 times a power of ten.
Scale linearScale(double high) {
    double step = powerOfTenBelow(high);
    for (const double part : {0.2, 0.5, 1.0}) {
        if (high <= 10 * part * powerOfTenBelow(high)) {
            step = part * powerOfTenBelow(high);
            break;
        }
    }
    const int steps = int(std::ceil(high / step));
    Scale scale{false, 0, steps * step, {}};
    for (int tick = 0; tick <= steps; ++tick) {
        scale.ticks.push_back(tick * step);
    }
    return scale;
}

struct Mark {
    double x, y, low, high;
};

struct Series {
    QString name;
    QColor colour;
    std::vector<Mark> marks;
    bool joined = true;
};

struct Panel {
    QString title, below;
    Scale x, y;
    std::vector<Series> series;
};

QString tickLabel(double value) {
    return QLocale(QLocale::English).toString(value, 'f', 0);
}

// Returns the smallest and the largest value over all marks of all series.
std::pair<double, double> heights(const std::vector<Series>& all) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Series& series : all) {
        for (const Mark& mark : series.marks) {
            low = std::min(low, mark.low);
            high = std::max(high, mark.high);
        }
    }
    return {low, high};
}

class PanelPainter {
public:
    PanelPainter(QPainter& painter, const QRectF& frame, const Panel& panel)
        : painter_(painter), frame_(frame), plot_(frame.adjusted(92, 44, -24, -56)), panel_(panel),
          metrics_(painter.font()) {}

    void draw() {
        drawGrid();
        drawTitles();
        for (const Series& series : panel_.series) {
            drawSeries(series);
        }
        drawKeys();
    }

private:
    double placeX(double value) const { return panel_.x.place(value, plot_.left(), plot_.right()); }
    double placeY(double value) const { return panel_.y.place(value, plot_.bottom(), plot_.top()); }

    void drawGrid() {
        const QPen line(QColor(222, 222, 222), 1), words(QColor(60, 60, 60));
        for (const double tick : panel_.x.ticks) {
            const double x = placeX(tick);
            painter_.setPen(line);
            painter_.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
            painter_.setPen(words);
            painter_.drawText(QRectF(x - 60, plot_.bottom() + 6, 120, 20), Qt::AlignCenter,
                              tickLabel(tick));
        }
        for (const double tick : panel_.y.ticks) {
            const double y = placeY(tick);
            painter_.setPen(line);
            painter_.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
            painter_.setPen(words);
            painter_.drawText(QRectF(frame_.left(), y - 10, plot_.left() - frame_.left() - 8, 20),
                              Qt::AlignRight | Qt::AlignVCenter, tickLabel(tick));
        }
        painter_.setPen(QPen(QColor(120, 120, 120), 1));
        painter_.drawRect(plot_);
    }

    void drawTitles() {
        painter_.setPen(Qt::black);
        painter_.drawText(QRectF(frame_.left(), frame_.top() + 8, frame_.width(), 24),
                          Qt::AlignCenter, panel_.title);
        painter_.drawText(QRectF(plot_.left(), plot_.bottom() + 28, plot_.width(), 22),
                          Qt::AlignCenter, panel_.below);
        painter_.save();
        painter_.translate(frame_.left() + 14, plot_.center().y());
        painter_.rotate(-90);
        painter_.drawText(QRectF(-plot_.height() / 2, -11, plot_.height(), 22), Qt::AlignCenter,
                          QStringLiteral("steps per second"));
        painter_.restore();
    }

    void drawSeries(const Series& series) {
        QPainterPath curve;
        for (const Mark& mark : series.marks) {
            const QPointF at(placeX(mark.x), placeY(mark.y));
            curve.elementCount() == 0 ? curve.moveTo(at) : curve.lineTo(at);
            painter_.setPen(QPen(series.colour, 1.4));
            painter_.drawLine(QPointF(at.x(), placeY(mark.low)),
                              QPointF(at.x(), placeY(mark.high)));
            drawMark(series, at);
        }
        if (series.joined) {
            painter_.setPen(QPen(series.colour, 1.8));
            painter_.setBrush(Qt::NoBrush);
            painter_.drawPath(curve);
        }
    }

    void drawMark(const Series& series, const QPointF& at) {
        painter_.setPen(QPen(series.colour, 1.8));
        painter_.setBrush(series.joined ? QBrush(series.colour) : QBrush(Qt::white));
        painter_.drawEllipse(at, 4, 4);
    }

    // Draws the legend at the lower left. Both figures leave this corner free, because rates fall
    // to the right or stay level.
    void drawKeys() {
        double y = plot_.bottom() - 22 * double(panel_.series.size());
        for (const Series& series : panel_.series) {
            drawMark(series, QPointF(plot_.left() + 22, y));
            painter_.setPen(Qt::black);
            painter_.drawText(QPointF(plot_.left() + 36, y + metrics_.ascent() / 2 - 2),
                              series.name);
            y += 22;
        }
    }

    QPainter& painter_;
    QRectF frame_, plot_;
    const Panel& panel_;
    QFontMetricsF metrics_;
};

Mark markOf(double x, const StepRow& row) {
    const Statistics& rate = row.stepsPerSecond;
    return {x, rate.median, rate.minimum, rate.maximum};
}

Panel constraintsPanel(const BenchReport& report) {
    Series ours{report.solver.id, seriesColours[0], {}, true};
    Series paper{QStringLiteral("the paper, GeForce 940MX"), paperColour, {}, false};
    for (const StepRow& row : report.tableOne) {
        const double constraints = double(row.constraints);
        ours.marks.push_back(markOf(constraints, row));
        if (row.paper) {
            paper.marks.push_back({constraints, *row.paper, *row.paper, *row.paper});
        }
    }
    Panel panel{QStringLiteral("Steps per second by the film's constraints (sphere, field of ") +
                    cubed(128) + QChar(u')'),
                QStringLiteral("constraints"),
                {true, 100, 400000, {100, 1000, 10000, 100000}},
                {},
                {ours, paper}};
    const auto [low, high] = heights(panel.series);
    panel.y = logarithmicScale(low, high);
    return panel;
}

Panel fieldPanel(const BenchReport& report) {
    Panel panel{QStringLiteral("Steps per second by the field's resolution (21,600 points)"),
                QStringLiteral("samples along an edge of the field"),
                {},
                {},
                {}};
    for (const StepRow& row : report.fieldSweep) {
        if (panel.series.empty() || panel.series.back().name != row.body) {
            const QColor colour = seriesColours[panel.series.size() % seriesColours.size()];
            panel.series.push_back({row.body, colour, {}, true});
        }
        panel.series.back().marks.push_back(markOf(row.fieldSamples, row));
        if (panel.series.size() == 1) {
            panel.x.ticks.push_back(row.fieldSamples);
        }
    }
    panel.x.first = panel.x.ticks.front() / 1.25;
    panel.x.last = panel.x.ticks.back() * 1.25;
    panel.y = linearScale(heights(panel.series).second);
    return panel;
}

void drawFigures(QPaintDevice& device, const BenchReport& report) {
    std::vector<Panel> panels;
    if (!report.tableOne.empty()) {
        panels.push_back(constraintsPanel(report));
    }
    if (!report.fieldSweep.empty()) {
        panels.push_back(fieldPanel(report));
    }
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRect(QPoint(), plotSize), Qt::white);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(14);
    painter.setFont(font);
    painter.drawText(QRectF(0, plotSize.height() - 26, plotSize.width(), 22), Qt::AlignCenter,
                     report.device);
    const double width = double(plotSize.width()) / double(panels.size());
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const QRectF frame(double(i) * width, 0, width, plotSize.height() - 24);
        PanelPainter(painter, frame, panels[i]).draw();
    }
}

void drawSvg(const BenchReport& report, QIODevice& device) {
    QSvgGenerator svg;
    svg.setOutputDevice(&device);
    svg.setSize(plotSize);
    svg.setViewBox(QRect(QPoint(), plotSize));
    svg.setTitle(QStringLiteral("Steps per second"));
    drawFigures(svg, report);
}

QImage drawImage(const BenchReport& report) {
    QImage image(plotSize, QImage::Format_RGB32);
    drawFigures(image, report);
    return image;
}

} // namespace

void drawPlot(const BenchReport& report, const QString& path) {
    const bool isSvg = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
    writeAtomically(path, [&](QIODevice& device) {
        isSvg ? drawSvg(report, device) : writePng(drawImage(report), device, path);
    });
}

} // namespace dipwright::cli
