#include "base/NumberText.h"
#include "validation/PhysicsValidation.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PhysicsValidation)
};

QString error(const PhysicsResult& result, double value) {
    const auto number = [](double shown) { return withMinusSign(QString::number(shown, 'f', 3)); };
    return result.inMillimetres ? QStringLiteral("%1 mm").arg(number(value))
                                : QStringLiteral("%1 %").arg(number(value * 100));
}

// Seven colours that colour-blind readers can tell apart (after Okabe and Ito).
QColor seriesColour(std::size_t index) {
    static const std::array<QRgb, 7> colours{0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7,
                                             0xff56b4e9, 0xffe69f00, 0xff333333};
    return QColor::fromRgb(colours[index % colours.size()]);
}

// The plot of one kind of film. It shows the film radius over the arc length, both in mm from 0 to
// `longest`.
struct Plot {
    QRectF frame; // the whole plot with its titles
    double longest = 10;
    QRectF area() const { return frame.adjusted(52, 34, -16, -44); }
    QPointF at(double arc, double radius) const {
        return {area().left() + area().width() * arc / longest,
                area().bottom() - area().height() * radius / longest};
    }
};

void drawAxes(QPainter& painter, const Plot& plot, const QString& title) {
    const QFontMetricsF metrics(painter.font());
    for (int tick = 0; tick <= int(plot.longest); tick += 10) {
        painter.setPen(QPen(QColor(225, 225, 225), 1));
        painter.drawLine(plot.at(tick, 0), plot.at(tick, plot.longest));
        painter.drawLine(plot.at(0, tick), plot.at(plot.longest, tick));
        painter.setPen(QColor(70, 70, 70));
        const QString label = QString::number(tick);
        const double width = metrics.horizontalAdvance(label);
        painter.drawText(plot.at(tick, 0) + QPointF(-width / 2, 18), label);
        painter.drawText(plot.at(0, tick) + QPointF(-width - 8, metrics.ascent() / 2), label);
    }
    const QRectF& frame = plot.frame;
    const QRectF area = plot.area();
    painter.setPen(Qt::black);
    painter.drawText(QRectF(frame.left(), frame.top() + 4, frame.width(), 24), Qt::AlignCenter,
                     title);
    painter.drawText(QRectF(area.left(), area.bottom() + 22, area.width(), 20), Qt::AlignCenter,
                     Text::tr("arc length from the pole (mm)"));
    painter.save();
    painter.translate(frame.left() + 12, area.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-area.height() / 2, -10, area.height(), 20), Qt::AlignCenter,
                     Text::tr("film radius (mm)"));
    painter.restore();
}

// Draws the closed form as a line, the simulated film as dots, and the key.
void drawSeries(QPainter& painter, const Plot& plot, const PhysicsResult& result,
                std::size_t series) {
    std::vector<PhysicsResult::Sample> samples = result.samples;
    std::sort(samples.begin(), samples.end(),
              [](const auto& a, const auto& b) { return a.arc < b.arc; });
    QPainterPath curve(plot.at(samples.front().arc, samples.front().exact));
    for (const PhysicsResult::Sample& sample : samples) {
        curve.lineTo(plot.at(sample.arc, sample.exact));
    }
    painter.setPen(QPen(seriesColour(series), 1.6));
    painter.drawPath(curve);
    painter.setPen(Qt::NoPen);
    painter.setBrush(seriesColour(series));
    const std::size_t every = std::max<std::size_t>(samples.size() / 24, 1);
    for (std::size_t i = 0; i < samples.size(); i += every) {
        painter.drawEllipse(plot.at(samples[i].arc, samples[i].simulated), 3, 3);
    }
    painter.setBrush(Qt::NoBrush);
    const QPointF key(plot.area().left() + 14, plot.area().top() + 16 + 20 * double(series));
    painter.setPen(QPen(seriesColour(series), 2));
    painter.drawLine(key, key + QPointF(22, 0));
    painter.setPen(Qt::black);
    painter.drawText(key + QPointF(30, QFontMetricsF(painter.font()).ascent() / 2 - 1),
                     QStringLiteral("%1: %2").arg(result.body, error(result, result.rms)));
}

// Draws the plot of one kind of film, with each body at its finest resolution.
void drawLaw(QPainter& painter, const QRectF& frame, const std::vector<PhysicsResult>& results,
             const QString& film, int cells) {
    double longest = 1;
    for (const PhysicsResult& result : results) {
        for (const PhysicsResult::Sample& sample : result.samples) {
            longest = std::max({longest, sample.arc, sample.exact});
        }
    }
    const Plot plot{frame, std::ceil(longest / 10) * 10};
    drawAxes(painter, plot,
             Text::tr("%1 film, %2 cells in the contact radius").arg(film).arg(cells));
    std::size_t series = 0;
    for (const PhysicsResult& result : results) {
        if (result.film == film && result.cells == cells && !result.samples.empty()) {
            drawSeries(painter, plot, result, series++);
        }
    }
}

} // namespace

QString physicsTable(const std::vector<PhysicsResult>& results) {
    QStringList lines;
    const auto row = [&](const QStringList& cells) {
        static const std::array<int, 9> widths{27, 24, 6, 11, 11, 11, 21, 8, 7};
        QString line;
        for (int i = 0; i < cells.size(); ++i) {
            const int width = widths[std::size_t(i)];
            line += i < 2 ? cells[i].leftJustified(width) : cells[i].rightJustified(width);
        }
        while (line.endsWith(QLatin1Char(' '))) {
            line.chop(1);
        }
        lines << line;
    };
    row({Text::tr("body"), Text::tr("film"), Text::tr("cells"), Text::tr("rms"), Text::tr("mean"),
         Text::tr("max"), Text::tr("axes − diagonals"), Text::tr("steps"), QString()});
    for (const PhysicsResult& result : results) {
        row({result.body, result.film, result.cells ? QString::number(result.cells) : QString(),
             error(result, result.rms), error(result, result.mean), error(result, result.maximum),
             result.inMillimetres ? QString() : error(result, result.anisotropy),
             QString::number(result.steps), result.passed() ? Text::tr("ok") : Text::tr("FAILED")});
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QJsonObject physicsJson(const std::vector<PhysicsResult>& results) {
    QJsonArray rows;
    bool passed = true;
    for (const PhysicsResult& result : results) {
        passed = passed && result.passed();
        QJsonObject row{{"body", result.body},
                        {"film", result.film},
                        {"unit", result.inMillimetres ? "mm" : "1"},
                        {"rms", result.rms},
                        {"mean", result.mean},
                        {"max", result.maximum},
                        {"allowed", result.allowed},
                        {"steps", qint64(result.steps)},
                        {"seconds", result.seconds},
                        {"passed", result.passed()}};
        if (!result.inMillimetres) {
            row["cells"] = result.cells;
            row["axis_minus_diagonal"] = result.anisotropy;
        }
        rows.append(row);
    }
    return {{"version", 1}, {"passed", passed}, {"cases", rows}};
}

QImage physicsPlot(const std::vector<PhysicsResult>& results, QSize size) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(13);
    painter.setFont(font);
    int cells = 0;
    QStringList films;
    for (const PhysicsResult& result : results) {
        cells = std::max(cells, result.cells);
        if (!result.samples.empty() && !films.contains(result.film)) {
            films << result.film;
        }
    }
    const double width = films.isEmpty() ? 0 : double(size.width()) / double(films.size());
    for (int i = 0; i < films.size(); ++i) {
        drawLaw(painter, QRectF(i * width, 0, width, size.height()), results, films[i], cells);
    }
    return image;
}

} // namespace dipwright
