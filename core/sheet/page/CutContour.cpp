#include "sheet/page/CutContour.h"

#include "sheet/page/InkDistance.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/SheetRows.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace dipwright {
namespace {

constexpr double finestPlace = 0.1; // mm: least side of a cell
constexpr double mostPlaces = 4000; // cells along one side of the film
constexpr double straight = 0.02;   // mm: points nearer to the line are dropped

// Divides the film into square cells and marks those that contain ink. A border of empty cells
// surrounds them.
struct InkedPlaces {
    double size = finestPlace; // side of a cell, mm
    QSize grid;
    std::vector<unsigned char> inked;

    InkedPlaces(const Sheet& sheet, QSizeF film)
        : size(std::max(finestPlace, side(sheet, film) / mostPlaces)),
          grid(int(std::ceil(film.width() / size)) + 2, int(std::ceil(film.height() / size)) + 2),
          inked(std::size_t(grid.width()) * std::size_t(grid.height()), 0) {
        const QSize pixels = filmPixels(sheet);
        const double across = film.width() / pixels.width() / size;
        const double down = film.height() / pixels.height() / size;
        forInkedPixels(sheet, InkedPlates::All, [&](const QImage& mask, int first) {
            for (int y = 0; y < mask.height(); ++y) {
                const uchar* row = mask.constScanLine(y);
                for (int x = 0; x < mask.width(); ++x) {
                    if (row[x] != 0) {
                        mark(QRectF(x * across, (first + y) * down, across, down));
                    }
                }
            }
        });
    }

private:
    // Returns the length, in mm, that is divided into cells. A long roll has narrow rows of them.
    static double side(const Sheet& sheet, QSizeF film) {
        return sheet.rows ? std::sqrt(film.width() * film.height())
                          : std::max(film.width(), film.height());
    }
    // Marks every cell that a pixel overlaps.
    void mark(const QRectF& pixel) {
        for (int y = int(pixel.top()); y < pixel.bottom() && y + 2 < grid.height(); ++y) {
            for (int x = int(pixel.left()); x < pixel.right() && x + 2 < grid.width(); ++x) {
                inked[std::size_t(1 + y) * std::size_t(grid.width()) + std::size_t(1 + x)] = 1;
            }
        }
    }
};

// Follows the line along which the heights on a grid equal `level`, with lower heights on its left
// (marching squares, https://doi.org/10.1145/37402.37422).
class LevelLine {
public:
    LevelLine(const std::vector<float>& heights, QSize grid, float level)
        : heights_(heights), grid_(grid), level_(level) {
        for (int y = 0; y + 1 < grid.height(); ++y) {
            for (int x = 0; x + 1 < grid.width(); ++x) {
                addCell(x, y);
            }
        }
    }

    std::vector<QPolygonF> loops() const {
        std::vector<QPolygonF> found;
        std::unordered_map<qint64, bool> seen;
        for (const qint64 first : starts_) {
            QPolygonF loop;
            for (qint64 edge = first; !std::exchange(seen[edge], true); edge = next_.at(edge)) {
                loop << place(edge);
            }
            if (loop.size() > 2) {
                found.push_back(loop);
            }
        }
        return found;
    }

private:
    // Numbers an edge between neighbouring cells: twice the first cell's number, plus one if the
    // edge goes down.
    qint64 edge(int x, int y, bool down) const {
        return 2 * (qint64(y) * grid_.width() + x) + (down ? 1 : 0);
    }
    float height(qint64 place) const { return heights_[std::size_t(place)]; }
    QPointF place(qint64 edge) const {
        const qint64 at = edge / 2;
        const bool down = edge % 2 == 1;
        const float a = height(at);
        const float b = height(at + (down ? grid_.width() : 1));
        const double share = std::clamp(double((level_ - a) / (b - a)), 0.0, 1.0);
        return {double(at % grid_.width()) + (down ? 0 : share),
                double(at / grid_.width()) + (down ? share : 0)};
    }
    void addCell(int x, int y) {
        const qint64 at = qint64(y) * grid_.width() + x;
        const bool low[4] = {height(at) <= level_, height(at + 1) <= level_,
                             height(at + 1 + grid_.width()) <= level_,
                             height(at + grid_.width()) <= level_};
        // Clockwise from the top; side i lies between the corners i and i + 1.
        const qint64 sides[4] = {edge(x, y, false), edge(x + 1, y, true), edge(x, y + 1, false),
                                 edge(x, y, true)};
        // Clockwise round the cell, the line enters where the heights rise above the level and
        // leaves at the next side where they fall below it. Two high corners at opposite ends of a
        // cell therefore stay separate.
        for (int side = 0; side < 4; ++side) {
            if (!low[side] || low[(side + 1) % 4]) {
                continue;
            }
            int back = (side + 1) % 4;
            while (low[back] || !low[(back + 1) % 4]) {
                back = (back + 1) % 4;
            }
            next_[sides[side]] = sides[back];
            starts_.push_back(sides[side]);
        }
    }

    const std::vector<float>& heights_;
    QSize grid_;
    float level_;
    std::unordered_map<qint64, qint64> next_;
    std::vector<qint64> starts_; // keys of next_ in a fixed order
};

double doubleArea(const QPolygonF& loop) {
    double sum = 0;
    for (qsizetype i = 0; i < loop.size(); ++i) {
        const QPointF& a = loop[i];
        const QPointF& b = loop[(i + 1) % loop.size()];
        sum += a.x() * b.y() - b.x() * a.y();
    }
    return sum;
}

// Keeps the points of an open line that are needed for the tolerance (Douglas and Peucker, 1973).
void keepNeeded(const QPolygonF& line, qsizetype first, qsizetype last, double tolerance,
                QPolygonF& kept) {
    const QPointF way = line[last] - line[first];
    const double length = std::hypot(way.x(), way.y());
    double most = 0;
    qsizetype farthest = first;
    for (qsizetype i = first + 1; i < last; ++i) {
        const QPointF off = line[i] - line[first];
        const double distance = length > 0
                                    ? std::abs(way.x() * off.y() - way.y() * off.x()) / length
                                    : std::hypot(off.x(), off.y());
        if (distance > most) {
            most = distance;
            farthest = i;
        }
    }
    if (most > tolerance) {
        keepNeeded(line, first, farthest, tolerance, kept);
        keepNeeded(line, farthest, last, tolerance, kept);
    } else {
        kept << line[last];
    }
}

QPolygonF simplified(QPolygonF loop, double tolerance) {
    loop << loop.first();
    QPolygonF kept{loop.first()};
    const qsizetype half = loop.size() / 2;
    keepNeeded(loop, 0, half, tolerance, kept);
    keepNeeded(loop, half, loop.size() - 1, tolerance, kept);
    return kept;
}

} // namespace

QPainterPath cutContour(const Sheet& sheet, const SheetLayout& layout) {
    QPainterPath path;
    const SheetSettings& settings = sheet.settings;
    if (settings.cutLine == CutLine::Film) {
        for (const SheetPiece& piece : layout.pieces) {
            path.addRect(piece.box());
        }
        if (layout.pieces.empty()) {
            path.addRect(layout.film);
        }
    }
    if (settings.cutLine != CutLine::Ink) {
        return path;
    }
    const InkedPlaces places(sheet, layout.film.size());
    std::vector<float> distances = distancesTo(places.inked, places.grid);
    for (int y = 0; y < places.grid.height(); ++y) {
        for (int x = 0; x < places.grid.width(); ++x) {
            if (x == 0 || y == 0 || x + 1 == places.grid.width() || y + 1 == places.grid.height()) {
                distances[std::size_t(y) * std::size_t(places.grid.width()) + std::size_t(x)] =
                    1e9f; // heights of the border, so that every line is closed
            }
        }
    }
    // The ink reaches half a cell beyond the cell's middle.
    const auto level = float(settings.cutDistance.value() / places.size + 0.5);
    const QTransform toPage = QTransform::fromScale(places.size, places.size) *
                              QTransform::fromTranslate(layout.film.x() - places.size / 2,
                                                        layout.film.y() - places.size / 2);
    for (const QPolygonF& loop : LevelLine(distances, places.grid, level).loops()) {
        if (doubleArea(loop) > 0) { // an outer edge, not the edge of a hole
            QPolygonF onPage = toPage.map(simplified(loop, straight / places.size));
            for (QPointF& point : onPage) {
                point.setX(std::clamp(point.x(), layout.film.left(), layout.film.right()));
                point.setY(std::clamp(point.y(), layout.film.top(), layout.film.bottom()));
            }
            path.addPolygon(onPage);
            path.closeSubpath();
        }
    }
    return path;
}

EnclosedPlaces::EnclosedPlaces(const Sheet& sheet, QSizeF film) {
    const InkedPlaces places(sheet, film);
    size_ = places.size;
    grid_ = places.grid;
    const int width = grid_.width(), height = grid_.height();
    const auto index = [&](QPoint cell) {
        return std::size_t(cell.y()) * std::size_t(width) + std::size_t(cell.x());
    };
    const QRect all(QPoint(), grid_);
    // From the border over bare cells.
    std::vector<unsigned char> isOpen(places.inked.size(), 0);
    std::vector<QPoint> ahead{{0, 0}};
    isOpen.front() = 1;
    while (!ahead.empty()) {
        const QPoint cell = ahead.back();
        ahead.pop_back();
        for (const QPoint& way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)}) {
            const QPoint next = cell + way;
            if (all.contains(next) && places.inked[index(next)] == 0 && isOpen[index(next)] == 0) {
                isOpen[index(next)] = 1;
                ahead.push_back(next);
            }
        }
    }
    // Cells that are partly inked count by the cells round them.
    isEnclosed_.assign(places.inked.size(), 0);
    for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
            bool besideOpen = false, besideEnclosed = false;
            for (int other = 0; other < 9; ++other) {
                const std::size_t near = index({x - 1 + other % 3, y - 1 + other / 3});
                besideOpen |= isOpen[near] != 0;
                besideEnclosed |= isOpen[near] == 0 && places.inked[near] == 0;
            }
            isEnclosed_[index({x, y})] = besideEnclosed && !besideOpen ? 1 : 0;
        }
    }
}

bool EnclosedPlaces::contains(QPointF place) const {
    const int x = 1 + int(place.x() / size_), y = 1 + int(place.y() / size_);
    return isEnclosed_[std::size_t(y) * std::size_t(grid_.width()) + std::size_t(x)] != 0;
}

double cutReach(const SheetSettings& settings) {
    return settings.cutLine == CutLine::Ink ? (settings.cutDistance + settings.cutBleed).value()
                                            : 0;
}

} // namespace dipwright
