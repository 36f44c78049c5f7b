#include "sheet/prepress/Separation.h"

#include "base/ImageRows.h"
#include "parallel/ParallelFor.h"
#include "sheet/page/InkDistance.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/prepress/PlateCompensation.h"
#include "sheet/prepress/PrinterColour.h"
#include "texture/Bleed.h"
#include "texture/StretchPlane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace dipwright {

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
    std::vector<unsigned char> bare(width * std::size_t(box.height()));
    for (int y = 0; y < box.height(); ++y) {
        const uchar* row = tint.constScanLine(box.y() + y) + box.x();
        std::transform(row, row + width, bare.begin() + std::ptrdiff_t(width) * y,
                       [](uchar value) { return uchar(value == 0); });
    }
    const std::vector<float> distances = distancesTo(bare, box.size());
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

std::vector<SpotPlate> spotsOf(const Sheet& sheet, const PrinterColour& colour) {
    std::vector<SpotPlate> spots;
    for (const SheetPlate& plate : sheet.plates) {
        SpotPlate spot{{plate.name, {}}, plate.first, {}};
        if (plate.alternate.isValid()) {
            QImage pixel(1, 1, QImage::Format_RGB888);
            pixel.fill(plate.alternate);
            const QByteArray inks = colour.cmyk(pixel);
            std::transform(inks.begin(), inks.end(), spot.ink.alternate.begin(),
                           [](char ink) { return uchar(ink) / 255.0; });
        }
        for (int y = 0; y < plate.tint.height(); ++y) {
            spot.tint.append(reinterpret_cast<const char*>(plate.tint.constScanLine(y)),
                             plate.tint.width());
        }
        spots.push_back(spot);
    }
    return spots;
}

QImage tintOf(const QImage& picture) {
    QImage tint(picture.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < tint.height(); ++y) {
        const uchar* pixel = picture.constScanLine(y);
        for (int x = 0; x < tint.width(); ++x) {
            tint.scanLine(y)[x] = pixel[4 * x];
        }
    }
    return tint;
}

// Continues the tints at a plate's edges outwards by `radius` pixels.
QImage continuedTint(const QImage& tint, double radius) {
    QImage picture(tint.size(), QImage::Format_RGBA8888);
    for (int y = 0; y < tint.height(); ++y) {
        const uchar* value = tint.constScanLine(y);
        uchar* pixel = picture.scanLine(y);
        for (int x = 0; x < tint.width(); ++x, pixel += 4) {
            std::fill_n(pixel, 4, value[x]);
            pixel[3] = value[x] != 0 ? 255 : 0;
        }
    }
    continueColour(picture, radius);
    return tintOf(picture);
}

// Continues all plates of the sheet past the cut contour.
Sheet withCutBleed(const Sheet& sheet) {
    const SheetSettings& settings = sheet.settings;
    if (settings.cutLine != CutLine::Ink || settings.cutBleed.value() <= 0) {
        return sheet;
    }
    const double radius = (settings.cutDistance + settings.cutBleed).value() * sheet.image.width() /
                          sheet.filmWidth.value();
    Sheet wider = sheet;
    continueColour(wider.image, radius);
    for (SheetPlate& plate : wider.plates) {
        plate.tint = continuedTint(plate.tint, radius);
    }
    if (wider.wanted) {
        QImage stretch = pictureOfStretch(wider.wanted->stretch, wider.wanted->image);
        continueColour(stretch, radius);
        wider.wanted->stretch = stretchOfPicture(stretch);
        continueColour(wider.wanted->image, radius);
        wider.wanted->inks = wider.wanted->inks.each([&](QImage plane) {
            continueColour(plane, radius);
            return plane;
        });
    }
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
            for (int ink = 0; ink < 4 && share > 0; ++ink) {
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

// Returns rows of a film's wanted inks. They share the film's pixels.
WantedInk rowsOf(const WantedInk& film, int first, int end) {
    const auto rows = [&](const QImage& image) { return imageRows(image, first, end); };
    return {rows(film.image), rows(film.stretch), film.settings, film.inks.each(rows)};
}

std::optional<PlateCompensation> lawOf(const Sheet& sheet, const PrintCorrection& correction) {
    return sheet.wanted ? std::optional<PlateCompensation>(std::in_place, *correction.colour,
                                                           sheet.wanted->settings)
                        : std::nullopt;
}

// The sums of the tints of cyan, magenta, yellow and black, 255 for full tint of a pixel.
using TintSums = std::array<quint64, 4>;

TintSums separatedTints(const Sheet& sheet, const PrintCorrection& correction) {
    const std::optional<PlateCompensation> law = lawOf(sheet, correction);
    TintSums sums{};
    forImageRows(sheet.image, [&](const QImage& rows, int first) {
        const int end = first + rows.height();
        std::optional<WantedInk> wanted;
        if (sheet.wanted) {
            wanted = rowsOf(*sheet.wanted, first, end);
        }
        const QByteArray inks = inksOf(rows, wanted, correction, law ? &*law : nullptr);
        for (qsizetype byte = 0; byte < inks.size(); ++byte) {
            sums[std::size_t(byte % 4)] += uchar(inks[byte]);
        }
    });
    return sums;
}

TintSums estimatedTints(const QImage& picture) {
    TintSums sums{};
    forImageRows(picture, [&](const QImage& rows, int) {
        const QImage opaque = flattened(rows);
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

quint64 tintSum(const QImage& tint) {
    quint64 sum = 0;
    for (int y = 0; y < tint.height(); ++y) {
        const uchar* row = tint.constScanLine(y);
        sum = std::accumulate(row, row + tint.width(), sum);
    }
    return sum;
}

} // namespace

std::vector<InkArea> inkAreas(const Sheet& original, const PrintCorrection& correction) {
    const std::array<QString, 4> names{QStringLiteral("Cyan"), QStringLiteral("Magenta"),
                                       QStringLiteral("Yellow"), QStringLiteral("Black")};
    const bool isSeparated = correction.colour && correction.colour->isCmyk();
    const Sheet sheet = isSeparated ? withCutBleed(original) : original;
    const double unit = sheet.filmWidth.value() * sheet.filmHeight.value() /
                        (255.0 * sheet.image.width() * sheet.image.height());
    const TintSums sums =
        isSeparated ? separatedTints(sheet, correction) : estimatedTints(sheet.image);
    std::vector<InkArea> inks;
    const auto addSpots = [&](bool first) {
        for (const SheetPlate& plate : sheet.plates) {
            if (isSeparated && plate.first == first) {
                inks.push_back({plate.name, unit * double(tintSum(plate.tint)), -1,
                                !plate.alternate.isValid()});
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

std::array<char, 4> bareInks(const PrinterColour& colour) {
    QImage pixel(1, 1, QImage::Format_RGB888);
    pixel.fill(Qt::white);
    const QByteArray inks = colour.cmyk(pixel);
    return {inks[0], inks[1], inks[2], inks[3]};
}

Plates separate(const Sheet& original, const PrintCorrection& correction) {
    const Sheet sheet = withCutBleed(original);
    Plates plates{sheet.image.size(), {}, spotsOf(sheet, *correction.colour)};
    const std::optional<PlateCompensation> law = lawOf(sheet, correction);
    plates.cmyk = inksOf(sheet.image, sheet.wanted, correction, law ? &*law : nullptr);
    return plates;
}

double inkShortfall(const Sheet& sheet, const PrintCorrection& correction) {
    if (!sheet.wanted || !correction.colour || !correction.colour->isCmyk()) {
        return 0;
    }
    const PlateCompensation law(*correction.colour, sheet.wanted->settings);
    const QImage& stretch = sheet.wanted->stretch;
    std::vector<double> rows(std::size_t(stretch.height()), 0);
    forImageRows(sheet.wanted->image, [&](const QImage& image, int first) {
        const WantedInk film = rowsOf(*sheet.wanted, first, first + image.height());
        const QImage& grownBy = film.stretch;
        PerInk inks(film, correction, law);
        const auto* wanted = reinterpret_cast<const uchar*>(inks.wanted.constData());
        forPixels(inks.printed, grownBy, [&](qsizetype pixel, const uchar* printed, float grown) {
            for (int ink = 0; ink < 4; ++ink) {
                if (law.fallsShort(ink, wanted[4 * pixel + ink], printed[ink], grown)) {
                    rows[std::size_t(first + pixel / stretch.width())] += double(grown);
                    break;
                }
            }
        });
    });
    const double pixelArea = sheet.filmWidth.value() * sheet.filmHeight.value() /
                             (double(stretch.width()) * stretch.height());
    return pixelArea * std::accumulate(rows.begin(), rows.end(), 0.0);
}

} // namespace dipwright
