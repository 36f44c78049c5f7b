#include "results/Results.h"

#include "dip/FilmMarks.h"
#include "parallel/ParallelFor.h"
#include "results/FilmValues.h"
#include "results/Hatch.h"

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
// In none of the colour maps:
const QColor unknown(208, 60, 140);
const QColor past(255, 128, 96); // the end of the scale

// The values that the colours span, and which colours.
struct Scale {
    double low = 1;
    double high = 1;
    double step = 0.1;
    QString map;
    bool lowerHalf = false; // of the map's colours: up to its middle
    bool hasPast = false;   // values past `high` have a colour of their own

    double share(double value) const { return std::clamp((value - low) / (high - low), 0.0, 1.0); }
    // Of the colour map, from its first colour to its last.
    QColor colour(double place) const { return mapColour(map, lowerHalf ? place / 2 : place); }
};

double niceStep(double span) {
    const double rough = span / 6;
    const double decade = std::pow(10, std::floor(std::log10(rough)));
    for (double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= rough) {
            return factor * decade;
        }
    }
    return 10 * decade;
}

// From 1, unstretched, upwards; where film is compressed as well, evenly to both sides of 1. A few
// points that tore away do not take the colours from the others: they lie past the scale's end.
Scale scaleOf(std::vector<float> values) {
    constexpr double least = 0.02; // noise is not blown up to a picture
    constexpr double outliers = 0.002;
    std::sort(values.begin(), values.end());
    const auto last = double(values.size() - 1);
    const double lowest = values[std::size_t(std::floor(outliers * last))];
    const double highest = values[std::size_t(std::ceil((1 - outliers) * last))];
    Scale scale;
    const double above = std::clamp(highest - 1, least, 9.0);
    const double below = 1 - lowest;
    if (below > 0.1 * above && below > least / 2) {
        const double reach = std::min(std::max(above, below), 1.0); // nothing is shorter than 0
        scale.step = niceStep(2 * reach);
        const double end = std::ceil(reach / scale.step - 1e-6) * scale.step;
        scale.low = 1 - end;
        scale.high = 1 + end;
        scale.map = QStringLiteral("balance");
    } else {
        scale.step = niceStep(above);
        scale.high = 1 + std::ceil(above / scale.step - 1e-6) * scale.step;
        scale.map = QStringLiteral("lagoon");
    }
    return scale;
}

// Up to 1, from the most compressed place on.
Scale compressionScale(double least) {
    constexpr double shallowest = 0.05; // noise is not blown up to a picture
    const double depth = std::clamp(1 - least, shallowest, 1.0);
    Scale scale;
    scale.step = niceStep(depth);
    scale.low = std::max(1 - std::ceil(depth / scale.step - 1e-6) * scale.step, 0.0);
    scale.high = 1;
    scale.map = QStringLiteral("balance");
    scale.lowerHalf = true;
    return scale;
}

std::array<QRgb, 256> colourTable(const Scale& scale) {
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

// The film in colours; pale where it is not on the body, a dark line round what is, hatched and in
// a line of its colour what is marked.
class FilmPicture {
public:
    FilmPicture(const FilmValues& film, const solver::FilmGrid& grid, const Scale& scale,
                QSize size)
        : film_(film), grid_(grid), scale_(scale), size_(size), colours_(colourTable(scale)),
          reach_(std::max(1, size.height() / 1000)), hatch_(std::max(size.width(), size.height())) {
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
        const bool isPast = scale_.hasPast && value > scale_.high;
        const QRgb colour = std::isnan(value) ? unknown.rgb()
                            : isPast
                                ? past.rgb()
                                : colours_[std::size_t(std::lround(255 * scale_.share(value)))];
        if (!painted(column(x), row(y))) {
            return faded(colour);
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

    double column(int x) const { return columnAt(grid_, (x + 0.5) / size_.width()); }
    double row(int y) const { return rowAt(grid_, (y + 0.5) / size_.height()); }

    // Whether one of the pixels at this reach to all sides is not what this one `is`.
    template <typename Is>
    bool isBorder(int x, int y, int reach, const Is& is) const {
        return !(is(column(x - reach), row(y)) && is(column(x + reach), row(y)) &&
                 is(column(x), row(y - reach)) && is(column(x), row(y + reach)));
    }

    const FilmValues& film_;
    const solver::FilmGrid& grid_;
    const Scale& scale_;
    QSize size_;
    std::array<QRgb, 256> colours_;
    int reach_; // of the line round what is on the body, to each side, pixels
    Hatch hatch_;
};

QString unitSign(LengthUnit unit) {
    return unit == LengthUnit::Inch ? Text::tr("in") : Text::tr("mm");
}

// What a map is of, in words and colours.
struct MapSubject {
    QString title, explanation;
    QString unit;    // under the scale
    QString summary; // under the map
    Scale scale;
    LengthUnit length = LengthUnit::Millimetre; // of the rules along the film
    bool goesOn = false;                        // there are values past the scale's upper end
    std::uint8_t marks = 0;                     // solver::PointMark bits that are hatched somewhere
};

// The picture's parts, all measured in hundredths of its height.
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
        painter.drawImage(plot_, FilmPicture(values_, grid_, subject_.scale, pixels).draw());
        drawFrame(painter);
        drawScale(painter);
        drawSummary(painter);
        return picture_;
    }

private:
    static constexpr double rightMargin = 1;

    void letter(QPainter& painter, const QRectF& box, int flags, const QString& text, double size,
                const QColor& colour, bool bold = false) const {
        painter.save();
        painter.scale(1 / unit_, 1 / unit_);
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(std::max(1, int(std::lround(size * unit_))));
        font.setBold(bold);
        // Longer in other languages, and yet on the picture.
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

    // Lengths along the film's lower or left edge, from its upper left corner.
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
        const double room = subject_.scale.hasPast ? 4 : 0; // over the bar
        const QRectF bar(plot_.right() + 5, plot_.top() + room, 2.6, height - room);
        if (subject_.scale.hasPast) {
            drawPast(painter, QRectF(bar.left(), plot_.top(), bar.width(), 2.2));
        }
        QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
        for (int i = 0; i <= 64; ++i) {
            gradient.setColorAt(i / 64.0, subject_.scale.colour(i / 64.0));
        }
        painter.setPen(QPen(ink, 0.12));
        painter.setBrush(gradient);
        painter.drawRect(bar);
        const Scale& scale = subject_.scale;
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

    // What is past the scale's upper end.
    void drawPast(QPainter& painter, const QRectF& box) const {
        painter.setPen(QPen(ink, 0.12));
        painter.setBrush(past);
        painter.drawRect(box);
        letter(painter, QRectF(box.right() + 1.2, box.top(), 8, box.height()),
               Qt::AlignLeft | Qt::AlignVCenter, Text::tr("more"), 1.5, ink);
    }

    QString scaleLabel(double value) const {
        const Scale& scale = subject_.scale;
        int decimals = 1; // that tell the steps apart
        for (double step = 10 * scale.step; std::abs(step - std::round(step)) > 1e-6 * step;
             step *= 10) {
            ++decimals;
        }
        const QString number = QLocale().toString(value, 'f', decimals);
        const bool goesOn = subject_.goesOn && value > scale.high - scale.step / 2;
        return goesOn ? Text::tr("%1 and more").arg(number) : number;
    }

    void drawSummary(QPainter& painter) const {
        const QRectF box(plot_.left(), plot_.bottom() + 4.6, plot_.width(), 2);
        letter(painter, box, Qt::AlignLeft, subject_.summary, 1.6, ink);
        letter(painter, box.translated(0, 2.4), Qt::AlignLeft,
               Text::tr("Outlined: film on the body · pale: film left over"), 1.5, paleInk);
        drawMarks(painter, box.translated(0, 4.8));
    }

    void drawMarks(QPainter& painter, QRectF box) const {
        for (const solver::PointMark mark : filmMarks) {
            if (has(subject_.marks, mark)) {
                paintHatched(painter, QRectF(box.left(), box.top(), 3.2, 1.8), mark);
                letter(painter, box.translated(4, 0), Qt::AlignLeft, markText(mark), 1.5, ink);
                box.setLeft(box.left() + 24);
            }
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
    return value < 1000 ? QLocale().toString(value, 'f', 3) : QLocale().toString(value, 'g', 3);
}

MapSubject stretchSubject(const FilmValues& values) {
    const std::vector<float> painted = values.paintedValues();
    const Distribution stretch = distribution(painted);
    const Scale scale = scaleOf(painted);
    return {Text::tr("Stretch of the film"),
            Text::tr("Mean of each point's constraints, final over rest length; ink side up"),
            Text::tr("stretch\nmm per mm"),
            Text::tr("On the body: min %1 · mean %2 · 95 % %3 · max %4")
                .arg(rounded(stretch.minimum), rounded(stretch.mean), rounded(stretch.percentile95),
                     rounded(stretch.maximum)),
            scale,
            LengthUnit::Millimetre,
            stretch.maximum > scale.high};
}

MapSubject wrinklingSubject(const FilmValues& values, const Wrinkling& wrinkling) {
    return {
        Text::tr("Wrinkling of the film"),
        Text::tr("Smaller principal stretch; below 1 the film is compressed and may fold"),
        Text::tr("stretch\nmm per mm"),
        Text::tr("On the body: compressed by over 1 % on %1 % of the film · smallest stretch %2")
            .arg(QLocale().toString(100 * wrinkling.share, 'f', 1), rounded(wrinkling.least)),
        compressionScale(distribution(values.paintedValues()).minimum)};
}

// From 0 up to what all but a few points keep below, but to a few times `limit` at most: a few
// places that are far off do not take the colours from the others. `least`: noise is not blown up
// to a picture.
Scale changeScale(std::vector<float> values, double limit, double least) {
    constexpr double outliers = 0.01;
    constexpr double mostLimits = 4;
    std::sort(values.begin(), values.end());
    const double highest = std::max(
        least, double(values[std::size_t(std::ceil((1 - outliers) * double(values.size() - 1)))]));
    Scale scale;
    scale.step = highest < limit ? niceStep(highest) : limit;
    scale.low = 0;
    const double steps = std::ceil(highest / scale.step - 1e-6);
    scale.high = scale.step * (highest < limit ? steps : std::min(steps, mostLimits));
    scale.map = QStringLiteral("lagoon");
    scale.hasPast = double(values.back()) > scale.high;
    return scale;
}

// Distances over the film, as they are told.
struct ToldDistances {
    ToldDistances(const LaidFilm& laid, std::vector<float> millimetres, double limitMillimetres,
                  LengthUnit wanted)
        : unit(wanted),
          limit(wanted == LengthUnit::Inch ? twoDigits(limitMillimetres / millimetresPerInch)
                                           : limitMillimetres),
          values(laid, told(std::move(millimetres), wanted)), marks(values.showMarks(laid)),
          painted(values.paintedValues()),
          scale(changeScale(painted, limit, 0.02 / millimetresIn(wanted))) {}

    QString text(double value, int decimals) const {
        const int more = unit == LengthUnit::Inch ? 1 : 0; // about as fine as in millimetres
        return Text::tr("%1 %2", "a number and its unit")
            .arg(QLocale().toString(value, 'f', decimals + more), unitSign(unit));
    }

    LengthUnit unit;
    double limit;
    FilmValues values;
    std::uint8_t marks;
    std::vector<float> painted;
    Scale scale;

private:
    // The scale's steps are as large, which are to be read.
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

MapSubject certaintySubject(const ToldDistances& told) {
    return {Text::tr("Certainty of the sheet"),
            Text::tr("Numerical error of the ink's position; ink side up"),
            Text::tr("change\n%1").arg(unitSign(told.unit)),
            Text::tr("Limit: %1 · magenta: painted in only one of the dips")
                .arg(told.text(told.limit, 2)),
            told.scale,
            told.unit,
            false,
            told.marks};
}

MapSubject toleranceSubject(const ToldDistances& told) {
    return {Text::tr("Tolerance of the sheet"),
            Text::tr("How far the ink may land off its place on the body; ink side up"),
            Text::tr("off by\n± %1").arg(unitSign(told.unit)),
            Text::tr("On the body: 95 % within ±%1")
                .arg(told.text(distribution(told.painted).percentile95, 2)),
            told.scale,
            told.unit,
            false,
            told.marks};
}

} // namespace

QImage stretchMap(const LaidFilm& laid, int longEdge) {
    const FilmValues values(laid, laid.painted().pointMeans);
    return FilmMap(laid.film().grid, values, stretchSubject(values), longEdge).draw();
}

QImage wrinklingMap(const LaidFilm& laid, int longEdge) {
    const Wrinkling& wrinkling = laid.painted().wrinkling;
    const FilmValues values(laid, wrinkling.pointStretches);
    return FilmMap(laid.film().grid, values, wrinklingSubject(values, wrinkling), longEdge).draw();
}

QImage certaintyMap(const LaidFilm& laid, const std::vector<float>& changes, double limit,
                    int longEdge, LengthUnit unit) {
    const ToldDistances told(laid, changes, limit, unit);
    return FilmMap(laid.film().grid, told.values, certaintySubject(told), longEdge).draw();
}

QImage toleranceMap(const LaidFilm& laid, const std::vector<float>& spread, double limit,
                    int longEdge, LengthUnit unit) {
    const ToldDistances told(laid, spread, limit, unit);
    return FilmMap(laid.film().grid, told.values, toleranceSubject(told), longEdge).draw();
}

} // namespace dipwright
