#include "sheet/prepress/Separation.h"

#include "base/ImageRows.h"
#include "parallel/ParallelFor.h"
#include "sheet/page/CutContour.h"
#include "sheet/page/InkDistance.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/SheetRows.h"
#include "sheet/prepress/PlateCompensation.h"
#include "sheet/prepress/PrinterColour.h"
#include "texture/Bleed.h"
#include "texture/LinearLight.h"
#include "texture/StretchPlane.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Separation)
};

// Marks the pixels of `box` that have no tint and lie at a hard edge: beside a pixel with at least
// a quarter of the strongest tint. A tint that fades to nothing, as at the seam of two dips, has no
// edge that could show.
std::vector<unsigned char> hardEdges(const QImage& tint, const QRect& box) {
    int strongest = 0;
    for (int y = box.top(); y <= box.bottom(); ++y) {
        const uchar* const row = tint.constScanLine(y) + box.x();
        strongest = std::max<int>(strongest, *std::max_element(row, row + box.width()));
    }
    const auto isStrong = [&](int x, int y) {
        return box.contains(x, y) && 4 * tint.constScanLine(y)[x] >= strongest;
    };
    std::vector<unsigned char> edges;
    edges.reserve(std::size_t(box.width()) * std::size_t(box.height()));
    for (int y = box.top(); y <= box.bottom(); ++y) {
        for (int x = box.left(); x <= box.right(); ++x) {
            edges.push_back(tint.constScanLine(y)[x] == 0 &&
                            (isStrong(x - 1, y) || isStrong(x + 1, y) || isStrong(x, y - 1) ||
                             isStrong(x, y + 1)));
        }
    }
    return edges;
}

} // namespace

void limitInk(QByteArray& cmyk, double mostInk) {
    const int most = int(std::floor(mostInk * 255));
    auto* const pixels = reinterpret_cast<uchar*>(cmyk.data());
    parallelFor(0, int(cmyk.size() / 4), [&](int pixel) {
        uchar* const ink = pixels + qsizetype(pixel) * 4;
        const int colours = ink[0] + ink[1] + ink[2];
        if (colours + ink[3] <= most) {
            return;
        }
        ink[3] = uchar(std::min<int>(ink[3], most));
        for (int channel = 0; channel < 3 && colours > 0; ++channel) {
            ink[channel] = uchar(ink[channel] * (most - ink[3]) / colours); // rounded down
        }
    });
}

QImage choked(const QImage& tint, double choke) {
    // The bare pixels around the tints count, too.
    const QRect box = markedBox(tint).adjusted(-1, -1, 1, 1).intersected(tint.rect());
    if (choke <= 0 || box.isEmpty()) {
        return tint;
    }
    const auto width = std::size_t(box.width());
    const std::vector<float> distances = distancesTo(hardEdges(tint, box), box.size());
    QImage smaller = blankImage(tint.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < box.height(); ++y) {
        const uchar* const from = tint.constScanLine(box.y() + y) + box.x();
        uchar* const to = smaller.scanLine(box.y() + y) + box.x();
        for (std::size_t x = 0; x < width; ++x) {
            // Subtracts the half pixel between a bare pixel's middle and its edge.
            if (distances[std::size_t(y) * width + x] - 0.5 >= choke) {
                to[x] = from[x];
            }
        }
    }
    return smaller;
}

namespace {

SpotInk spotInk(const SheetPlate& plate, const PrinterColour& colour) {
    SpotInk ink{plate.name, {}};
    if (plate.alternate.isValid()) {
        QImage pixel(1, 1, QImage::Format_RGB888);
        pixel.fill(plate.alternate);
        const QByteArray inks = colour.cmyk(pixel);
        std::transform(inks.begin(), inks.end(), ink.alternate.begin(),
                       [](char share) { return uchar(share) / 255.0; });
    }
    return ink;
}

std::vector<SpotPlate> spotsOf(const Sheet& sheet, const PrinterColour& colour) {
    std::vector<SpotPlate> spots;
    for (const SheetPlate& plate : sheet.plates) {
        SpotPlate spot{spotInk(plate, colour), plate.first, {}};
        for (int y = 0; y < plate.tint.height(); ++y) {
            spot.tint.append(reinterpret_cast<const char*>(plate.tint.constScanLine(y)),
                             plate.tint.width());
        }
        spots.push_back(spot);
    }
    return spots;
}

// Returns for each pixel the nearest pixel at most `radius` pixels away for which `keeps` is true,
// its own first. RGBA64: column, row modulo 2¹⁶, the rest of the row; alpha 0: none.
template <typename Keeps>
QImage sourcesWhere(QSize pixels, double radius, const Keeps& keeps) {
    QImage sources(pixels, QImage::Format_RGBA64);
    sources.fill(Qt::transparent);
    parallelFor(0, pixels.height(), [&, to = sources.bits()](int y) {
        auto* const source = reinterpret_cast<QRgba64*>(to + y * sources.bytesPerLine());
        for (int x = 0; x < pixels.width(); ++x) {
            if (keeps(x, y)) {
                source[x] = qRgba64(quint16(x), quint16(y), quint16(y >> 16), 0xffff);
            }
        }
    });
    continueColour(sources, radius);
    return sources;
}

bool hasSource(const QImage& sources, int x, int y) {
    return reinterpret_cast<const QRgba64*>(sources.constScanLine(y))[x].alpha() != 0;
}

// Returns a plane in which each pixel has the value of its source.
QImage takenFrom(const QImage& sources, const QImage& plane) {
    QImage taken = plane;
    const qsizetype bytes = plane.depth() / 8;
    parallelFor(0, plane.height(), [&, to = taken.bits()](int y) {
        const auto* const source = reinterpret_cast<const QRgba64*>(sources.constScanLine(y));
        for (qsizetype x = 0; x < plane.width(); ++x) {
            if (source[x].alpha() != 0) {
                const int row = source[x].green() | source[x].blue() << 16;
                std::copy_n(plane.constScanLine(row) + bytes * source[x].red(), bytes,
                            to + y * taken.bytesPerLine() + bytes * x);
            }
        }
    });
    return taken;
}

// Where a cut contour's bleed lies. Lengths in pixels.
struct CutBleed {
    EnclosedPlaces enclosed; // no bleed reaches them
    double pixel;            // mm
    double radius, choke;    // from the ink to the end of the bleed; of white
};

// Returns a mask of the pixels that keep their values, 255: painted film and enclosed places. The
// sheet has the film's rows from `first` on.
QImage fixedPixels(const Sheet& sheet, const CutBleed& bleed, int first) {
    QImage fixed(sheet.image.size(), QImage::Format_Grayscale8);
    const PixelCode code(sheet.image);
    parallelFor(0, fixed.height(), [&, to = fixed.bits()](int y) {
        uchar* const row = to + y * fixed.bytesPerLine();
        const uchar* const picture = sheet.image.constScanLine(y);
        for (int x = 0; x < fixed.width(); ++x) {
            const QPointF place = bleed.pixel * QPointF(x + 0.5, first + y + 0.5);
            row[x] = code.alpha(picture + x * code.bytes()) != 0 || bleed.enclosed.contains(place)
                         ? 255
                         : 0;
        }
        for (const SheetPlate& plate : sheet.plates) {
            const uchar* const tint = plate.tint.constScanLine(y);
            std::transform(tint, tint + fixed.width(), row, row,
                           [](uchar ink, uchar known) { return ink != 0 ? uchar(255) : known; });
        }
    });
    return fixed;
}

// Continues all plates of the film's rows from `first` on. The pixels of the bleed get the values
// of the nearest pixel at the edge of the painted film. White begins further inside, so it is
// continued from its own edge.
void continuePlates(Sheet& sheet, const CutBleed& bleed, int first) {
    const QSize size = sheet.image.size();
    const QImage fixed = fixedPixels(sheet, bleed, first);
    const auto isFixed = [&](int x, int y) { return fixed.constScanLine(y)[x] != 0; };
    const QImage sources = sourcesWhere(size, bleed.radius, isFixed);
    const auto taken = [&](const QImage& plane) { return takenFrom(sources, plane); };
    const auto continuedWhite = [&](const QImage& tint) {
        const QImage edge =
            sourcesWhere(size, bleed.choke + 1, [&](int x, int y) { return !isFixed(x, y); });
        const auto keeps = [&](int x, int y) {
            return tint.constScanLine(y)[x] != 0 || !hasSource(edge, x, y);
        };
        return takenFrom(sourcesWhere(size, bleed.radius, keeps), tint);
    };
    for (SheetPlate& plate : sheet.plates) {
        plate.tint =
            isWhite(plate, sheet.settings) ? continuedWhite(plate.tint) : taken(plate.tint);
    }
    sheet.image = taken(sheet.image);
    if (sheet.wanted) {
        sheet.wanted->image = taken(sheet.wanted->image);
        sheet.wanted->stretch = taken(sheet.wanted->stretch);
        sheet.wanted->inks = sheet.wanted->inks.each(taken);
    }
}

// Continues all plates of the sheet past the cut contour.
Sheet withCutBleed(const Sheet& sheet) {
    const SheetSettings& settings = sheet.settings;
    if (settings.cutLine != CutLine::Ink || settings.cutBleed.value() <= 0) {
        return sheet;
    }
    const QSize pixels = filmPixels(sheet);
    const double pixel = sheet.filmWidth.value() / pixels.width();
    const CutBleed bleed{EnclosedPlaces(sheet, pixel * QSizeF(pixels)), pixel,
                         cutReach(settings) / pixel, settings.whiteChoke.value() / pixel};
    Sheet wider = sheet;
    if (!sheet.rows) {
        continuePlates(wider, bleed, 0);
        return wider;
    }
    const auto rows = [inner = sheet.rows, bleed](int first, int end) {
        const int reach = int(std::ceil(bleed.radius + bleed.choke + 1));
        const int from = std::max(first - reach, 0);
        Sheet more = inner->make(from, std::min(end + reach, inner->pixels.height()));
        continuePlates(more, bleed, from);
        const auto cropped = [&](const QImage& image) {
            return image.copy(0, first - from, image.width(), end - first);
        };
        const auto crop = [&](QImage& image) { image = cropped(image); };
        crop(more.image);
        for (SheetPlate& plate : more.plates) {
            crop(plate.tint);
        }
        if (more.wanted) {
            crop(more.wanted->image);
            crop(more.wanted->stretch);
            more.wanted->inks = more.wanted->inks.each(cropped);
        }
        return more;
    };
    wider.rows = std::make_shared<const FilmRows>(FilmRows{sheet.rows->pixels, rows});
    return wider;
}

// Calls work(pixel, inks, stretch) for every pixel; `inks` are its four bytes. Each row runs on one
// thread.
template <typename Work>
void forPixels(QByteArray& cmyk, const QImage& stretch, const Work& work) {
    auto* const bytes = reinterpret_cast<uchar*>(cmyk.data());
    parallelFor(0, stretch.height(), [&](int y) {
        const auto* codes = reinterpret_cast<const std::uint16_t*>(stretch.constScanLine(y));
        const qsizetype first = qsizetype(y) * stretch.width();
        for (int x = 0; x < stretch.width(); ++x) {
            work(first + x, bytes + 4 * (first + x), areaStretchOf(codes[x]));
        }
    });
}

// Replaces `wanted`, the separated colours, where the film has amounts of ink.
void takeInks(const InkPlanes& inks, const PrinterColour& colour, const PlateCompensation& law,
              QByteArray& wanted) {
    auto* const bytes = reinterpret_cast<uchar*>(wanted.data());
    const auto width = std::size_t(inks.colours.width());
    parallelFor(0, inks.colours.height(), [&](int y) {
        const uchar* const colours = inks.colours.constScanLine(y);
        const uchar* const black = inks.black.constScanLine(y);
        const std::span<uchar> row(bytes + 4 * width * std::size_t(y), 4 * width);
        std::vector<uchar> amounts(row.begin(), row.end());
        for (std::size_t at = 0; at < amounts.size(); at += 4) {
            std::copy_n(colours + at, 3, &amounts[at]);
            amounts[at + 3] = black[at];
        }
        colour.convertInks(amounts, inks.space, row);
        for (std::size_t at = 0; at < amounts.size(); at += 4) {
            const float share = float(black[at + 1]) / 255;
            if (share == 0 || std::equal(&amounts[at], &amounts[at] + 4, &row[at])) {
                continue; // separated, from colours that have only this film's share
            }
            for (int ink = 0; ink < 4; ++ink) {
                row[at + std::size_t(ink)] = law.faded(ink, amounts[at + std::size_t(ink)], share);
            }
        }
    });
}

// The picture's inks, each compensated separately.
struct PerInk {
    QByteArray wanted, printed; // four bytes per pixel

    PerInk(const WantedInk& film, const PrintCorrection& correction, const PlateCompensation& law)
        : wanted(correction.colour->cmyk(onWhitePaper(film.image))) {
        if (!film.inks.isNull()) {
            takeInks(film.inks, *correction.colour, law, wanted);
        }
        printed = wanted;
        if (film.settings.compensate) {
            forPixels(printed, film.stretch, [&](qsizetype, uchar* inks, float stretch) {
                for (int ink = 0; ink < 4; ++ink) {
                    inks[ink] = law.printed(ink, inks[ink], stretch);
                }
            });
        }
        if (correction.totalInk) {
            limitInk(printed, *correction.totalInk);
        }
    }
};

// Returns the inks of the sheet's picture, which may be some rows of a sheet. `law` is null if the
// sheet has no wanted colours.
QByteArray inksOf(const QImage& picture, const std::optional<WantedInk>& wanted,
                  const PrintCorrection& correction, const PlateCompensation* law) {
    if (wanted) {
        return PerInk(*wanted, correction, *law).printed;
    }
    QByteArray cmyk = correction.colour->cmyk(onWhitePaper(picture));
    if (correction.totalInk) {
        limitInk(cmyk, *correction.totalInk);
    }
    return cmyk;
}

std::unique_ptr<const PlateCompensation> lawOf(const Sheet& sheet,
                                               const PrintCorrection& correction) {
    return sheet.wanted ? std::make_unique<const PlateCompensation>(*correction.colour,
                                                                    sheet.wanted->settings)
                        : nullptr;
}

// Returns the picture of bytes that a copy of their own keeps. `format` is any format with as many
// bytes per pixel.
QImage pictureOf(const QByteArray& bytes, QSize size, QImage::Format format) {
    const qsizetype stride = bytes.size() / size.height();
    return QImage(reinterpret_cast<const uchar*>(bytes.constData()), size.width(), size.height(),
                  stride, format)
        .copy();
}

// The sums of the tints of cyan, magenta, yellow and black, 255 for full tint of a pixel.
using TintSums = std::array<quint64, 4>;

TintSums separatedTints(const Sheet& sheet, const PrintCorrection& correction) {
    const std::unique_ptr<const PlateCompensation> law = lawOf(sheet, correction);
    TintSums sums{};
    forSheetRows(sheet, [&](const Sheet& rows, int) {
        const QByteArray inks = inksOf(rows.image, rows.wanted, correction, law.get());
        for (qsizetype byte = 0; byte < inks.size(); ++byte) {
            sums[std::size_t(byte % 4)] += uchar(inks[byte]);
        }
    });
    return sums;
}

TintSums estimatedTints(const Sheet& sheet) {
    TintSums sums{};
    forSheetRows(sheet, [&](const Sheet& rows, int) {
        const QImage opaque = flattened(rows.image);
        for (int y = 0; y < opaque.height(); ++y) {
            const uchar* row = opaque.constScanLine(y);
            for (int x = 0; x < opaque.width(); ++x, row += 3) {
                for (std::size_t ink = 0; ink < 3; ++ink) {
                    sums[ink] += quint64(255 - row[ink]);
                }
            }
        }
    });
    return sums;
}

// Returns the sum of the tints of one of the sheet's plates.
quint64 tintSum(const Sheet& sheet, std::size_t plate) {
    quint64 sum = 0;
    forSheetRows(sheet, [&](const Sheet& rows, int) {
        const QImage& tint = rows.plates[plate].tint;
        for (int y = 0; y < tint.height(); ++y) {
            const uchar* row = tint.constScanLine(y);
            sum = std::accumulate(row, row + tint.width(), sum);
        }
    });
    return sum;
}

} // namespace

std::vector<InkArea> inkAreas(const Sheet& original, const PrintCorrection& correction) {
    const std::array<QString, 4> names{QStringLiteral("Cyan"), QStringLiteral("Magenta"),
                                       QStringLiteral("Yellow"), QStringLiteral("Black")};
    const bool isSeparated = correction.colour && correction.colour->isCmyk();
    const Sheet sheet = isSeparated ? withCutBleed(original) : original;
    const QSize pixels = filmPixels(sheet);
    const double unit = sheet.passes * sheet.filmWidth.value() * sheet.filmHeight.value() /
                        (255.0 * pixels.width() * pixels.height());
    const TintSums sums = isSeparated ? separatedTints(sheet, correction) : estimatedTints(sheet);
    std::vector<InkArea> inks;
    const auto addSpots = [&](bool first) {
        for (std::size_t i = 0; i < sheet.plates.size(); ++i) {
            const SheetPlate& plate = sheet.plates[i];
            if (isSeparated && plate.first == first) {
                inks.push_back(
                    {plate.name, unit * double(tintSum(sheet, i)), -1, !plate.alternate.isValid()});
            }
        }
    };
    addSpots(true);
    for (std::size_t ink = 0; ink < (isSeparated ? 4 : 3); ++ink) {
        inks.push_back({names[ink], unit * double(sums[ink]), int(ink)});
    }
    addSpots(false);
    return inks;
}

bool areEstimated(const std::vector<InkArea>& inks) {
    return std::none_of(inks.begin(), inks.end(),
                        [](const InkArea& ink) { return ink.process == 3; });
}

QStringList lostPlates(const Sheet& sheet, bool isSeparated) {
    QStringList sentences;
    if (isSeparated) {
        return sentences;
    }
    if (sheet.settings.white != WhiteLayer::None) {
        sentences << Text::tr("The white layer is left out: it needs a printer profile with an ICC "
                              "profile in CMYK");
    }
    if (std::any_of(sheet.plates.begin(), sheet.plates.end(),
                    [](const SheetPlate& plate) { return plate.alternate.isValid(); })) {
        sentences << Text::tr("The spot colours are left out: they need a printer profile with an "
                              "ICC profile in CMYK");
    }
    return sentences;
}

std::array<char, 4> bareInks(const PrinterColour& colour) {
    QImage pixel(1, 1, QImage::Format_RGB888);
    pixel.fill(Qt::white);
    const QByteArray inks = colour.cmyk(pixel);
    return {inks[0], inks[1], inks[2], inks[3]};
}

RowSeparation::RowSeparation(const Sheet& sheet, const PrintCorrection& correction)
    : sheet_(withCutBleed(sheet)), correction_(correction), law_(lawOf(sheet, correction)) {}

RowSeparation::~RowSeparation() = default;

QByteArray RowSeparation::cmyk(const Sheet& rows) const {
    return inksOf(rows.image, rows.wanted, correction_, law_.get());
}

Plates RowSeparation::plates(int first, int end) const {
    const Sheet rows = sheetRows(sheet_, first, end);
    return {rows.image.size(), cmyk(rows), spotsOf(rows, *correction_.colour)};
}

PackedPlates RowSeparation::packed() const {
    const QSize size = filmPixels(sheet_);
    PackedPlates packed{size, {}, {}};
    packed.cmyk = packedPixels({size, 4, 8, [&](int first, int end) {
                                    const Sheet rows = sheetRows(sheet_, first, end);
                                    return pictureOf(cmyk(rows), rows.image.size(),
                                                     QImage::Format_RGBX8888); // any of four bytes
                                }});
    for (std::size_t i = 0; i < sheet_.plates.size(); ++i) {
        const SheetPlate& plate = sheet_.plates[i];
        packed.spots.push_back(
            {spotInk(plate, *correction_.colour), plate.first,
             packedPixels({size, 1, 8, [&](int first, int end) {
                               return sheetRows(sheet_, first, end).plates[i].tint;
                           }})});
    }
    return packed;
}

Plates separate(const Sheet& sheet, const PrintCorrection& correction) {
    return RowSeparation(sheet, correction).plates(0, filmPixels(sheet).height());
}

double inkShortfall(const Sheet& sheet, const PrintCorrection& correction) {
    if (!sheet.wanted || !sheet.wanted->settings.compensate || !correction.colour ||
        !correction.colour->isCmyk()) {
        return 0;
    }
    const PlateCompensation law(*correction.colour, sheet.wanted->settings);
    const QSize pixels = filmPixels(sheet);
    std::vector<double> sums(std::size_t(pixels.height()), 0); // of each row
    forSheetRows(sheet, [&](const Sheet& rows, int first) {
        PerInk inks(*rows.wanted, correction, law);
        const auto* wanted = reinterpret_cast<const uchar*>(inks.wanted.constData());
        forPixels(inks.printed, rows.wanted->stretch,
                  [&](qsizetype pixel, const uchar* printed, float grown) {
                      for (int ink = 0; ink < 4; ++ink) {
                          if (law.fallsShort(ink, wanted[4 * pixel + ink], printed[ink], grown)) {
                              sums[std::size_t(first + pixel / pixels.width())] += double(grown);
                              break;
                          }
                      }
                  });
    });
    const double pixelArea = sheet.filmWidth.value() * sheet.filmHeight.value() /
                             (double(pixels.width()) * pixels.height());
    return pixelArea * std::accumulate(sums.begin(), sums.end(), 0.0);
}

} // namespace dipwright
