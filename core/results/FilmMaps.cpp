#include "base/NumberText.h"
#include "results/DifferenceMap.h"
#include "results/Results.h"

#include "dip/FilmMarks.h"
#include "parallel/ParallelFor.h"
#include "results/FilmValues.h"
#include "results/Hatch.h"
#include "results/MapScale.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Results)
};

const QColor background(252, 252, 252);
const QColor ink(38, 42, 48);
const QColor paleInk(105, 112, 120);
const QColor unusedFilm(214, 214, 214); // where a map has no values

// Returns a scale from the stretch of the most compressed place up to 1.
MapScale compressionScale(double least) {
    constexpr double shallowest = 0.05; // a smaller range would show only noise
    const double depth = std::clamp(1 - least, shallowest, 1.0);
    MapScale scale;
    scale.step = niceStep(depth);
    scale.low = std::max(1 - std::ceil(depth / scale.step - 1e-6) * scale.step, 0.0);
    scale.high = 1;
    scale.map = QStringLiteral("balance");
    scale.lowerHalf = true;
    return scale;
}

std::array<QRgb, 256> colourTable(const MapScale& scale) {
    std::array<QRgb, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = scale.colour(double(i) / 255).rgb();
    }
    return table;
}

QRgb faded(QRgb colour) {
    const auto part = [](int value, int white) { return (value + 3 * white) / 4; };
    return qRgb(part(qRed(colour), background.red()), part(qGreen(colour), background.green()),
                part(qBlue(colour), background.blue()));
}

// Draws the values on the film in colours. Film off the body is pale, or grey if it has no values;
// painted film has a dark outline. Marked film is hatched and outlined in the colour of its mark.
class FilmPicture {
public:
    FilmPicture(const FilmValues& film, const solver::FilmGrid& grid, const MapScale& scale,
                bool isOfWholeFilm, QSize size)
        : film_(film), scale_(scale), isOfWholeFilm_(isOfWholeFilm), size_(size),
          colours_(colourTable(scale)), past_(scale.past().rgb()),
          reach_(std::max(1, size.height() / 1000)), hatch_(std::max(size.width(), size.height())) {
        for (int x = -margin(); x < size.width() + margin(); ++x) {
            columns_.push_back(columnAt(grid, (x + 0.5) / size.width()));
        }
        for (int y = -margin(); y < size.height() + margin(); ++y) {
            rows_.push_back(rowAt(grid, (y + 0.5) / size.height()));
        }
    }

    QImage draw() const {
        QImage picture(size_, QImage::Format_RGB32);
        uchar* bits = picture.bits();
        parallelFor(0, size_.height(), [&, stride = picture.bytesPerLine()](int y) {
            auto* line = reinterpret_cast<QRgb*>(bits + y * stride);
            for (int x = 0; x < size_.width(); ++x) {
                line[x] = pixel(x, y);
            }
        });
        return picture;
    }

private:
    QRgb pixel(int x, int y) const {
        const auto painted = [this](double i, double j) { return film_.isPainted(i, j); };
        const auto marked = [this](double i, double j) { return film_.mark(i, j).has_value(); };
        const double value = film_.at(column(x), row(y));
        const bool isPast = scale_.hasColourAbove && value > scale_.high;
        const QRgb colour = std::isnan(value) ? paintedOnceColour.rgb()
                            : isPast
                                ? past_
                                : colours_[std::size_t(std::lround(255 * scale_.share(value)))];
        if (!painted(column(x), row(y))) {
            return isOfWholeFilm_ ? faded(colour) : unusedFilm.rgb();
        }
        if (isBorder(x, y, reach_, painted)) {
            return ink.rgb();
        }
        const auto mark = film_.mark(column(x), row(y));
        return !mark                                ? colour
               : isBorder(x, y, 2 * reach_, marked) ? markColour(*mark).rgb()
               : hatch_.isOn(x, y)                  ? hatch_.colour(x, y, *mark)
                                                    : colour;
    }

    int margin() const { return 2 * reach_; } // pixels beyond the picture that isBorder() needs
    double column(int x) const { return columns_[std::size_t(x + margin())]; }
    double row(int y) const { return rows_[std::size_t(y + margin())]; }

    // Tells whether any pixel at this distance to a side does not satisfy `is`.
    template <typename Is>
    bool isBorder(int x, int y, int reach, const Is& is) const {
        return !(is(column(x - reach), row(y)) && is(column(x + reach), row(y)) &&
                 is(column(x), row(y - reach)) && is(column(x), row(y + reach)));
    }

    const FilmValues& film_;
    const MapScale& scale_;
    bool isOfWholeFilm_;
    QSize size_;
    std::array<QRgb, 256> colours_;
    QRgb past_; // colour of values above the scale
    int reach_; // half the width of the outline of painted film, pixels
    Hatch hatch_;
    std::vector<double> columns_, rows_; // of the pixels and a margin, in cells
};

QString unitSign(LengthUnit unit) {
    return unit == LengthUnit::Inch ? Text::tr("in") : Text::tr("mm");
}

// The texts and colours of a map.
struct MapSubject {
    QString title, explanation;
    QString unit;    // under the scale
    QString summary; // under the map
    MapScale scale;
    LengthUnit length = LengthUnit::Millimetre; // unit of the rulers along the film
    bool hasHigherValues = false;               // whether some values lie above the scale
    std::uint8_t marks = 0;                     // solver::PointMark bits that the map shows
    bool isOfWholeFilm = false;                 // whether film off the part has values, too
};

// Draws a map with title, rulers and scale. Lengths are in per cent of the picture's height.
class FilmMap {
public:
    FilmMap(const solver::FilmGrid& grid, FilmValues values, MapSubject subject, int longEdge)
        : grid_(grid), values_(std::move(values)), subject_(std::move(subject)),
          unit_(longEdge / 100.0) {
        const double height = 78;
        const double width = std::clamp(height * grid_.width / grid_.depth, 20.0, 250.0);
        plot_ = QRectF(9, 12, width, height);
        if (grid_.width > grid_.depth) {
            plot_.setHeight(width * grid_.depth / grid_.width);
        }
        picture_ = QImage(QSizeF((plot_.right() + 22) * unit_,
                                 (plot_.bottom() + (subject_.marks ? 12.4 : 10)) * unit_)
                              .toSize(),
                          QImage::Format_RGB32);
    }

    QImage draw() {
        picture_.fill(background);
        QPainter painter(&picture_);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        painter.scale(unit_, unit_);
        drawTitle(painter);
        const QSize pixels = (plot_.size() * unit_).toSize();
        painter.drawImage(
            plot_,
            FilmPicture(values_, grid_, subject_.scale, subject_.isOfWholeFilm, pixels).draw());
        drawFrame(painter);
        drawScale(painter);
        drawSummary(painter);
        return picture_;
    }

private:
    static constexpr double rightMargin = 1, markSize = 1.5;

    QFont fontOf(double size) const {
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(std::max(1, int(std::lround(size * unit_))));
        return font;
    }
    double textWidth(const QString& text, double size) const {
        return QFontMetricsF(fontOf(size)).horizontalAdvance(text) / unit_;
    }
    void letter(QPainter& painter, const QRectF& box, int flags, const QString& text, double size,
                const QColor& colour, bool bold = false) const {
        painter.save();
        painter.scale(1 / unit_, 1 / unit_);
        QFont font = fontOf(size);
        font.setBold(bold);
        // Texts in other languages may be longer; they must still fit.
        const double room = picture_.width() - (box.left() + rightMargin) * unit_;
        const double width = QFontMetricsF(font).horizontalAdvance(text);
        if (width > room) {
            font.setPixelSize(std::max(1, int(font.pixelSize() * room / width)));
        }
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(QRectF(box.topLeft() * unit_, box.size() * unit_),
                         flags | Qt::TextDontClip, text);
        painter.restore();
    }

    void drawTitle(QPainter& painter) const {
        const QRectF box(plot_.left(), 2.5, plot_.width(), 3);
        letter(painter, box, Qt::AlignLeft, subject_.title, 2.6, ink, true);
        letter(painter, box.translated(0, 4), Qt::AlignLeft, subject_.explanation, 1.6, paleInk);
    }

    void drawFrame(QPainter& painter) const {
        painter.setPen(QPen(ink, 0.15));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(plot_);
        drawRule(painter, grid_.width, true);
        drawRule(painter, grid_.depth, false);
    }

    // Draws a ruler along the film's lower or left edge, starting at its upper left corner.
    void drawRule(QPainter& painter, double millimetres, bool across) const {
        const double length = millimetres / millimetresIn(subject_.length);
        const double step = niceStep(length);
        const int ticks = int(std::floor(length * 1.0001 / step));
        for (int number = 0; number <= ticks; ++number) {
            const double value = number * step;
            const double share = value / length;
            const QPointF end = across
                                    ? QPointF(plot_.left() + share * plot_.width(), plot_.bottom())
                                    : QPointF(plot_.left(), plot_.top() + share * plot_.height());
            const QPointF tick = across ? QPointF(0, 0.8) : QPointF(-0.8, 0);
            painter.setPen(QPen(ink, 0.12));
            painter.drawLine(end, end + tick);
            const QRectF box = across ? QRectF(end.x() - 5, end.y() + 1.1, 10, 2)
                                      : QRectF(end.x() - 11.2, end.y() - 1, 10, 2);
            const int flags =
                across ? Qt::AlignHCenter | Qt::AlignTop : Qt::AlignRight | Qt::AlignVCenter;
            letter(painter, box, flags, QLocale().toString(value), 1.5, paleInk);
        }
        if (across) {
            letter(painter, QRectF(plot_.right() + 1, plot_.bottom() + 1.1, 6, 2),
                   Qt::AlignLeft | Qt::AlignTop, unitSign(subject_.length), 1.5, paleInk);
        }
    }

    void drawScale(QPainter& painter) const {
        const double height = std::min(plot_.height(), 60.0);
        const double room = subject_.scale.hasColourAbove ? 4 : 0; // room over the bar
        const QRectF bar(plot_.right() + 5, plot_.top() + room, 2.6, height - room);
        if (subject_.scale.hasColourAbove) {
            drawLegendAbove(painter, QRectF(bar.left(), plot_.top(), bar.width(), 2.2));
        }
        QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
        for (int i = 0; i <= 64; ++i) {
            gradient.setColorAt(i / 64.0, subject_.scale.colour(i / 64.0));
        }
        painter.setPen(QPen(ink, 0.12));
        painter.setBrush(gradient);
        painter.drawRect(bar);
        const MapScale& scale = subject_.scale;
        const int ticks = int(std::lround((scale.high - scale.low) / scale.step));
        for (int number = 0; number <= ticks; ++number) {
            const double value = scale.low + number * scale.step;
            const double y = bar.bottom() - scale.share(value) * bar.height();
            painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 0.7, y));
            letter(painter, QRectF(bar.right() + 1.2, y - 1, 8, 2),
                   Qt::AlignLeft | Qt::AlignVCenter, scaleLabel(value), 1.5, ink);
        }
        letter(painter, QRectF(bar.left(), bar.bottom() + 1.6, 14, 2), Qt::AlignLeft, subject_.unit,
               1.5, paleInk);
    }

    // Draws the legend for values above the scale.
    void drawLegendAbove(QPainter& painter, const QRectF& box) const {
        painter.setPen(QPen(ink, 0.12));
        painter.setBrush(subject_.scale.past());
        painter.drawRect(box);
        letter(painter, QRectF(box.right() + 1.2, box.top(), 8, box.height()),
               Qt::AlignLeft | Qt::AlignVCenter, Text::tr("more"), 1.5, ink);
    }

    QString scaleLabel(double value) const {
        const MapScale& scale = subject_.scale;
        const QString number = scale.text(value);
        const bool hasHigherValues =
            subject_.hasHigherValues && value > scale.high - scale.step / 2;
        return hasHigherValues ? Text::tr("%1 and more").arg(number) : number;
    }

    void drawSummary(QPainter& painter) const {
        const QRectF box(plot_.left(), plot_.bottom() + 4.6, plot_.width(), 2);
        letter(painter, box, Qt::AlignLeft, subject_.summary, 1.6, ink);
        letter(painter, box.translated(0, 2.4), Qt::AlignLeft,
               subject_.isOfWholeFilm
                   ? Text::tr("Dark outline: film on the part · pale: unused film")
                   : Text::tr("Dark outline: film on the part · grey: unused film"),
               1.5, paleInk);
        drawMarks(painter, box.translated(0, 4.8));
    }

    void drawMarks(QPainter& painter, QRectF box) const {
        constexpr double sample = 4, gap = 3;
        std::vector<solver::PointMark> marks;
        double texts = 0; // their width at full size
        for (const solver::PointMark mark : filmMarks) {
            if (has(subject_.marks, mark)) {
                marks.push_back(mark);
                texts += textWidth(markText(mark), markSize);
            }
        }
        const double room = picture_.width() / unit_ - rightMargin - box.left() -
                            double(marks.size()) * (sample + gap);
        const double size = markSize * std::min(1.0, room / texts);
        for (const solver::PointMark mark : marks) {
            paintHatched(painter, QRectF(box.left(), box.top(), 3.2, 1.8), mark);
            letter(painter, box.translated(sample, 0), Qt::AlignLeft, markText(mark), size, ink);
            box.setLeft(box.left() + sample + textWidth(markText(mark), size) + gap);
        }
    }

    solver::FilmGrid grid_;
    FilmValues values_;
    MapSubject subject_;
    double unit_; // pixels
    QRectF plot_;
    QImage picture_;
};

QString rounded(double value) {
    return value < 1000 ? numberText(value, 3) : roundedText(value, 3);
}

// `stretch` is the distribution that report and window give.
MapSubject stretchSubject(const FilmValues& values, const Distribution& stretch) {
    const std::vector<float> painted = values.paintedValues();
    const MapScale scale = stretchScale(painted);
    return {
        Text::tr("Stretch of the film"),
        Text::tr("Mean stretch at each point: final length divided by rest length; ink side up"),
        Text::tr("stretch\nmm per mm"),
        Text::tr("Stretch of the film on the part: min. %1 · mean %2 · 95 % below %3 · max. %4")
            .arg(rounded(stretch.minimum), rounded(stretch.mean), rounded(stretch.percentile95),
                 rounded(stretch.maximum)),
        scale,
        LengthUnit::Millimetre,
        distribution(painted).maximum > scale.high,
        0,
        true};
}

MapSubject wrinklingSubject(const FilmValues& values, const Wrinkling& wrinkling) {
    return {
        Text::tr("Wrinkling of the film"),
        Text::tr("Smaller principal stretch; below 1 the film is compressed and may fold"),
        Text::tr("stretch\nmm per mm"),
        Text::tr("On the part: %1 % of the film is compressed by over 1 % · smallest stretch %2")
            .arg(numberText(100 * wrinkling.share, 1), rounded(wrinkling.least)),
        compressionScale(distribution(values.paintedValues()).minimum),
        LengthUnit::Millimetre,
        false,
        0,
        true};
}

// Distances on the film, in the unit that the map shows.
struct ShownDistances {
    ShownDistances(const LaidFilm& laid, std::vector<float> millimetres, double limitMillimetres,
                   LengthUnit wanted)
        : unit(wanted),
          limit(wanted == LengthUnit::Inch ? twoDigits(limitMillimetres / millimetresPerInch)
                                           : limitMillimetres),
          values(laid, told(std::move(millimetres), wanted)), marks(values.showMarks(laid)),
          painted(values.paintedValues()),
          scale(changeScale(painted, limit, 0.02 / millimetresIn(wanted))) {}

    QString text(double value, int decimals) const {
        const int more =
            unit == LengthUnit::Inch ? 1 : 0; // resolves about as much as millimetres do
        return Text::tr("%1 %2", "a number and its unit")
            .arg(numberText(value, decimals + more), unitSign(unit));
    }

    LengthUnit unit;
    double limit;
    FilmValues values;
    std::uint8_t marks;
    std::vector<float> painted;
    MapScale scale;

private:
    // The scale's steps equal the limit, so it is rounded to be readable.
    static double twoDigits(double value) {
        const double decade = std::pow(10, std::floor(std::log10(value)) - 1);
        return std::round(value / decade) * decade;
    }
    static std::vector<float> told(std::vector<float> millimetres, LengthUnit wanted) {
        for (float& distance : millimetres) {
            distance = float(distance / millimetresIn(wanted));
        }
        return millimetres;
    }
};

MapSubject numericalErrorSubject(const ShownDistances& told) {
    return {Text::tr("Numerical error of the sheet"),
            Text::tr("How far the image may be off because of the film's cells and the solver's "
                     "steps; ink side up"),
            Text::tr("error\n%1").arg(unitSign(told.unit)),
            Text::tr("Limit: %1 · black: painted by only one of the compared dips")
                .arg(told.text(told.limit, 2)),
            told.scale,
            told.unit,
            false,
            told.marks};
}

MapSubject differenceSubject(const ShownDistances& told, double scaleEnd) {
    constexpr double steps = 5;
    MapScale scale = told.scale;
    scale.high = scaleEnd / millimetresIn(told.unit);
    scale.step = scale.high / steps;
    scale.hasColourAbove =
        double(*std::max_element(told.painted.begin(), told.painted.end())) > scale.high;
    return {Text::tr("Difference of two sheets"),
            Text::tr("How far the image is from its place on the other sheet; ink side up"),
            Text::tr("distance\n%1").arg(unitSign(told.unit)),
            Text::tr("Black: painted in only one of the two states"),
            scale,
            told.unit,
            false,
            told.marks};
}

MapSubject toleranceSubject(const ShownDistances& told) {
    return {Text::tr("Tolerance of the sheet"),
            Text::tr("How far handling may move the image on the part; ink side up"),
            Text::tr("shift\n± %1").arg(unitSign(told.unit)),
            Text::tr("On the part: 95 % of the image moves by ±%1 or less")
                .arg(told.text(distribution(told.painted).percentile95, 2)),
            told.scale,
            told.unit,
            false,
            told.marks};
}

} // namespace

QImage stretchMap(const LaidFilm& laid, int longEdge) {
    const FilmValues values(laid, laid.painted().pointMeans);
    const MapSubject subject = stretchSubject(values, distribution(laid.painted().constraints));
    return FilmMap(laid.film().grid, values, subject, longEdge).draw();
}

QImage wrinklingMap(const LaidFilm& laid, int longEdge) {
    const Wrinkling& wrinkling = laid.painted().wrinkling;
    const FilmValues values(laid, wrinkling.pointStretches);
    return FilmMap(laid.film().grid, values, wrinklingSubject(values, wrinkling), longEdge).draw();
}

QImage numericalErrorMap(const LaidFilm& laid, const std::vector<float>& changes, double limit,
                         int longEdge, LengthUnit unit) {
    const ShownDistances told(laid, changes, limit, unit);
    return FilmMap(laid.film().grid, told.values, numericalErrorSubject(told), longEdge).draw();
}

QImage toleranceMap(const LaidFilm& laid, const std::vector<float>& spread, double limit,
                    int longEdge, LengthUnit unit) {
    const ShownDistances told(laid, spread, limit, unit);
    return FilmMap(laid.film().grid, told.values, toleranceSubject(told), longEdge).draw();
}

double differenceScaleEnd(std::vector<float> moves, LengthUnit unit) {
    constexpr double least = 0.1; // mm; a smaller range would show only noise
    std::erase_if(moves, [](float move) { return !(move >= 0); });
    const double highest = moves.empty() ? least : std::max(least, highestOf(std::move(moves)));
    return millimetresIn(unit) * roundedUp(highest / millimetresIn(unit));
}

QImage differenceMap(const LaidFilm& laid, const std::vector<float>& moves, double scaleEnd,
                     int longEdge, LengthUnit unit) {
    const ShownDistances told(laid, moves, scaleEnd, unit);
    return FilmMap(laid.film().grid, told.values, differenceSubject(told, scaleEnd), longEdge)
        .draw();
}

} // namespace dipwright
