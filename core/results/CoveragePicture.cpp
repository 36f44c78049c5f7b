#include "results/Results.h"

#include "parallel/ParallelFor.h"
#include "results/BodyViews.h"
#include "results/FilmValues.h"
#include "results/ProofScene.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QLocale>
#include <QPainter>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Results)
};

const QColor background(252, 252, 252);
const QColor ink(38, 42, 48);
const QColor seamColour(255, 221,
                        87);        // colour of the seam; visible on painterColour(Painter::Both)
const QColor pale(232, 235, 238);   // film that paints nothing
constexpr float shownBand = 0.98f;  // part of the overlap in which each dip gives at least 1 %
constexpr double seamWidth = 0.004; // width of the seam relative to the body's diagonal

LinearColour linear(const QColor& colour) {
    const std::array<float, 256>& light = linearTable();
    return {light[std::size_t(colour.red())], light[std::size_t(colour.green())],
            light[std::size_t(colour.blue())]};
}

// Returns which dip paints a place that `dip` or both dips reach. `inside` is the distance from the
// seam towards the side of `dip`, as a multiple of the overlap's width.
Painter painterAt(float inside, std::size_t dip) {
    const Painter own = dip == 0 ? Painter::First : Painter::Second;
    const Painter other = dip == 0 ? Painter::Second : Painter::First;
    return std::abs(inside) < shownBand / 2 ? Painter::Both : inside > 0 ? own : other;
}

// Returns the width of the drawn seam as a multiple of the overlap's width.
float seamWidthIn(const BodyShare& share, const Eigen::AlignedBox3f& box) {
    return float(seamWidth * double(box.diagonal().norm()) / std::max(share.overlap.middle, 0.1));
}

// The body in the colours of the dips, shaded: bright where it faces the viewer.
class SharedBody {
public:
    SharedBody(const ProofStage& stage, const BodyShare& share)
        : stage_(stage), share_(share), joinWidth_(seamWidthIn(share, stage.box)) {}

    LinearColour light(const BodyRay& ray, const SurfacePoint& seen) const {
        if (!seen.isValid()) {
            return linear(background);
        }
        const SurfacePoint point = stage_.fine->onCoarse(seen);
        const float facing = std::abs(normalAt(stage_.normals, point).dot(ray.direction));
        return linear(colour(share_.fade.mesh == stage_.fine ? seen
                                                             : share_.fade.mesh->onFine(point))) *
               (0.35f + 0.65f * facing);
    }

private:
    QColor colour(const SurfacePoint& fine) const {
        if (share_.painters[fine.triangle] == Painter::None) {
            return painterColour(Painter::None);
        }
        const float inside = share_.fade.atFine(fine);
        const bool joins = share_.painters[fine.triangle] == Painter::Both;
        return joins && std::abs(inside) < joinWidth_ / 2 ? seamColour
                                                          : painterColour(painterAt(inside, 0));
    }

    const ProofStage& stage_;
    const BodyShare& share_;
    float joinWidth_;
};

void letter(QPainter& painter, const QRect& box, int flags, const QString& text, int size) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(size);
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(box, flags, text);
}

// Returns the font size, at most `size`, at which the longest text fits into `width`.
int letterSize(const std::vector<ShareLine>& lines, int width, int size) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(size);
    int longest = 1;
    for (const ShareLine& line : lines) {
        longest = std::max(longest, QFontMetrics(font).horizontalAdvance(line.text));
    }
    return std::clamp(size * width / longest, 1, size);
}

void drawLegend(QPainter& painter, const QRect& room, const std::vector<ShareLine>& lines) {
    QRect box(room.x(), room.y(), room.width(), room.width() / 10);
    const int side = box.height() / 2;
    const int size = letterSize(lines, room.width() - 3 * side, room.width() / 20);
    for (const ShareLine& line : lines) {
        painter.setPen(ink);
        painter.setBrush(line.colour);
        painter.drawRect(box.x(), box.y() + side / 2, 2 * side, side);
        letter(painter, box.adjusted(3 * side, 0, 0, 0), Qt::AlignVCenter, line.text, size);
        box.translate(0, box.height());
    }
}

} // namespace

std::vector<ShareLine> shareLines(const BodyShare& share, const QStringList& dips) {
    const QLocale locale;
    const auto line = [&](Painter painter, const QString& name, double area) {
        return ShareLine{painterColour(painter),
                         Text::tr("%1: %2 mm², %3 %")
                             .arg(name, locale.toString(area, 'f', 0),
                                  locale.toString(100 * area / share.areas.total(), 'f', 1))};
    };
    return {line(Painter::First, dips[0], share.areas.first),
            line(Painter::Second, dips[1], share.areas.second),
            line(Painter::Both, Text::tr("Both, in the overlap"), share.areas.both),
            line(Painter::None, Text::tr("Not painted"), share.areas.none),
            {seamColour, Text::tr("Seam: %1 mm").arg(locale.toString(share.cost.length, 'f', 0))}};
}

QImage sharePicture(const LaidFilm& laid, const BodyShare& share, std::size_t dip, QSize pixels) {
    const PaintShare own = share.of(dip);
    std::vector<float> inside, joining; // as multiples of the overlap's width; NaN: no value
    for (const SurfacePoint& point : laid.contact().surface) {
        const float distance = point.isValid() ? own.fade.at(point) : std::nanf("");
        const bool joins = point.isValid() &&
                           share.painters[own.fade.mesh->onFine(point).triangle] == Painter::Both;
        inside.push_back(own.isFirst ? distance : -distance);
        joining.push_back(joins ? std::abs(distance) : std::nanf(""));
    }
    const FilmValues values(laid, std::move(inside));
    const FilmValues joins(laid, std::move(joining));
    const solver::FilmGrid& grid = laid.film().grid;
    const float width = seamWidthIn(share, boundingBox(laid.body().mesh));
    const auto colour = [&](double column, double row) {
        const auto distance = float(values.at(column, row));
        if (!values.isPainted(column, row) || std::isnan(distance)) {
            return pale;
        }
        return joins.at(column, row) < double(width) / 2 ? seamColour
                                                         : painterColour(painterAt(distance, dip));
    };
    QImage picture(pixels, QImage::Format_RGB32);
    uchar* bits = picture.bits();
    parallelFor(0, pixels.height(), [&, stride = picture.bytesPerLine()](int y) {
        auto* line = reinterpret_cast<QRgb*>(bits + y * stride);
        for (int x = 0; x < pixels.width(); ++x) {
            line[x] = colour(columnAt(grid, (x + 0.5) / pixels.width()),
                             rowAt(grid, (y + 0.5) / pixels.height()))
                          .rgb();
        }
    });
    return picture;
}

QImage coveragePicture(const ProofStage& stage, const BodyShare& share,
                       const std::vector<SharedFilm>& films, int tile, const Progress& progress) {
    const std::vector<BodyCamera> cameras = sixSides(stage.box, 0);
    const QSize view(tile, tile);
    const float span = commonSpan(cameras, stage.mesh, view);
    const int gap = tile / 16;
    QImage picture(sideColumns * tile, 3 * tile + 3 * gap, QImage::Format_RGB888);
    picture.fill(background);
    const SharedBody body(stage, share);
    for (int number = 0; number < int(cameras.size()); ++number) {
        progress(0.9 * number / double(cameras.size()), Text::tr("Drawing the coverage picture"));
        const BodyCamera& camera = cameras[std::size_t(number)];
        drawView(
            picture, sideBox(number, view), camera.see(stage.fine->mesh(), span, view),
            [&](const BodyRay& ray, const SurfacePoint& seen) { return body.light(ray, seen); },
            camera, span, progress.cancelToken);
    }
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    nameSides(painter, view);
    QStringList dips;
    for (std::size_t dip = 0; dip < films.size(); ++dip) {
        const solver::FilmGrid& grid = films[dip].laid->film().grid;
        const QRect room(int(dip) * tile + gap, 2 * tile + 2 * gap, tile - 2 * gap, tile);
        const QSize size =
            QSizeF(grid.width, grid.depth).scaled(room.size(), Qt::KeepAspectRatio).toSize();
        const QRect box(room.topLeft(), size);
        painter.drawImage(box, sharePicture(*films[dip].laid, share, dip, size));
        painter.setPen(ink);
        painter.drawRect(box);
        letter(painter, QRect(room.x(), 2 * tile + gap / 2, room.width(), gap), Qt::AlignLeft,
               Text::tr("Film of %1").arg(films[dip].name), tile / 24);
        dips.append(films[dip].name);
    }
    drawLegend(painter, QRect(2 * tile + gap, 2 * tile + 2 * gap, tile - 2 * gap, tile),
               shareLines(share, dips));
    return picture;
}

} // namespace dipwright
