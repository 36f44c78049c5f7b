#include "sheet/prepress/PlateProof.h"

#include "base/ImageRows.h"
#include "base/Png.h"
#include "parallel/ParallelFor.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "texture/LinearLight.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

const std::array<QString, 4> processInks{QStringLiteral("Cyan"), QStringLiteral("Magenta"),
                                         QStringLiteral("Yellow"), QStringLiteral("Black")};
constexpr int fullTint = 255;
constexpr int mostSum = 4 * fullTint;

QColor colourOf(const PrinterColour& colour, const std::array<double, 4>& inks) {
    QByteArray pixel;
    for (const double ink : inks) {
        pixel.append(char(std::lround(fullTint * ink)));
    }
    return colour.screen(pixel, {1, 1}).pixelColor(0, 0);
}

bool isWhite(const SpotInk& ink) {
    return std::all_of(ink.alternate.begin(), ink.alternate.end(),
                       [](double amount) { return amount == 0; });
}

const uchar* processRow(const Plates& plates, int row) {
    return reinterpret_cast<const uchar*>(plates.cmyk.constData()) +
           qsizetype(4) * row * plates.size.width();
}

const uchar* spotRow(const Plates& plates, std::size_t spot, int row) {
    return reinterpret_cast<const uchar*>(plates.spots[spot].tint.constData()) +
           qsizetype(row) * plates.size.width();
}

int sumOf(const uchar* inks) {
    return inks[0] + inks[1] + inks[2] + inks[3];
}

// Counts of pixels.
struct Counts {
    std::vector<std::array<quint64, 256>> tints; // of each channel
    std::array<quint64, mostSum + 1> sums{};     // of the four inks
    int mostOfAll = 0;

    explicit Counts(int channels) : tints(std::size_t(channels)) {}
    void add(const Plates& plates, int row) {
        const uchar* inks = processRow(plates, row);
        for (int x = 0; x < plates.size.width(); ++x, inks += 4) {
            for (std::size_t ink = 0; ink < 4; ++ink) {
                ++tints[ink][inks[ink]];
            }
            const int sum = sumOf(inks);
            ++sums[std::size_t(sum)];
            int all = sum;
            for (std::size_t spot = 0; spot < plates.spots.size(); ++spot) {
                const uchar tint = spotRow(plates, spot, row)[x];
                ++tints[4 + spot][tint];
                all += tint;
            }
            mostOfAll = std::max(mostOfAll, all);
        }
    }
    void add(const Counts& other) {
        for (std::size_t channel = 0; channel < tints.size(); ++channel) {
            std::transform(tints[channel].begin(), tints[channel].end(),
                           other.tints[channel].begin(), tints[channel].begin(), std::plus());
        }
        std::transform(sums.begin(), sums.end(), other.sums.begin(), sums.begin(), std::plus());
        mostOfAll = std::max(mostOfAll, other.mostOfAll);
    }
};

Counts countsOf(const Plates& plates) {
    constexpr int band = 256; // rows
    const int bands = (plates.size.height() + band - 1) / band;
    std::vector<Counts> parts(std::size_t(bands), Counts(plates.channels()));
    parallelFor(0, bands, [&](int number) {
        const int end = std::min((number + 1) * band, plates.size.height());
        for (int row = number * band; row < end; ++row) {
            parts[std::size_t(number)].add(plates, row);
        }
    });
    Counts counts(plates.channels());
    for (const Counts& part : parts) {
        counts.add(part);
    }
    return counts;
}

PlateFigures figuresOf(const ProofPlate& plate, const std::array<quint64, 256>& counts,
                       double pixelArea) {
    PlateFigures figures{plate};
    for (int tint = 1; tint <= fullTint; ++tint) {
        const double area = pixelArea * double(counts[std::size_t(tint)]);
        figures.fullTintArea += area * tint / fullTint;
        figures.inkedArea += area;
        figures.mostTint = area > 0 ? double(tint) / fullTint : figures.mostTint;
    }
    return figures;
}

// Returns the largest sum that counts as within the limit.
int mostWithin(const std::optional<double>& limit) {
    return limit ? int(std::floor(*limit * fullTint + 1e-6)) : mostSum;
}

QString percent(double share) {
    return QString::number(100 * share, 'f', 1);
}

// Multiplies the print by the ground, as far as white does not cover it, and by the spot inks.
void addSpots(QImage& print, const Plates& plates, const std::vector<ProofPlate>& spots,
              const QColor& ground) {
    const LinearColour beneath = linearColour(ground);
    std::vector<LinearColour> lights;
    for (const ProofPlate& spot : spots) {
        lights.push_back(linearColour(spot.colour));
    }
    uchar* const bits = print.bits();
    const qsizetype stride = print.bytesPerLine();
    parallelFor(0, print.height(), [&](int y) {
        uchar* pixel = bits + y * stride;
        for (int x = 0; x < print.width(); ++x, pixel += 3) {
            LinearColour through = LinearColour::Ones(), below = beneath;
            for (std::size_t spot = 0; spot < spots.size(); ++spot) {
                const float tint =
                    float(spotRow(plates, std::size_t(spots[spot].channel - 4), y)[x]) / fullTint;
                if (spots[spot].isWhite) {
                    below = below * (1 - tint) + tint;
                } else {
                    through *= 1 - tint * (1 - lights[spot]);
                }
            }
            through *= below;
            for (int channel = 0; channel < 3; ++channel) {
                pixel[channel] = encodedByte(linearTable()[pixel[channel]] * through[channel]);
            }
        }
    });
}

QString fileName(std::size_t number, const QString& ink) {
    static const QRegularExpression unsafe(QStringLiteral("[^A-Za-z0-9]+"));
    return QStringLiteral("plate-%1-%2.png").arg(number).arg(QString(ink).replace(unsafe, "-"));
}

} // namespace

std::vector<ProofPlate> proofPlates(const Plates& plates, const PrinterColour& colour) {
    std::vector<ProofPlate> all;
    const auto addSpotPlates = [&](bool first) {
        for (std::size_t spot = 0; spot < plates.spots.size(); ++spot) {
            const SpotInk& ink = plates.spots[spot].ink;
            if (plates.spots[spot].first == first) {
                all.push_back(
                    {ink.name, 4 + int(spot), colourOf(colour, ink.alternate), isWhite(ink)});
            }
        }
    };
    addSpotPlates(true);
    for (std::size_t ink = 0; ink < processInks.size(); ++ink) {
        std::array<double, 4> full{};
        full[ink] = 1;
        all.push_back({processInks[ink], int(ink), colourOf(colour, full)});
    }
    addSpotPlates(false);
    return all;
}

InkFigures inkFigures(const Plates& plates, const PrinterColour& colour, QSizeF film,
                      const std::optional<double>& limit) {
    const Counts counts = countsOf(plates);
    const double pixelArea =
        film.width() * film.height() / (double(plates.size.width()) * plates.size.height());
    InkFigures figures;
    figures.limit = limit;
    figures.mostOfAllPlates = double(counts.mostOfAll) / fullTint;
    for (const ProofPlate& plate : proofPlates(plates, colour)) {
        figures.plates.push_back(
            figuresOf(plate, counts.tints[std::size_t(plate.channel)], pixelArea));
    }
    const quint64 inked = std::accumulate(counts.sums.begin() + 1, counts.sums.end(), quint64(0));
    figures.inkedArea = pixelArea * double(inked);
    quint64 below = 0;
    for (int sum = 1; sum <= mostSum; ++sum) {
        const quint64 count = counts.sums[std::size_t(sum)];
        if (count > 0) {
            figures.mostInk = double(sum) / fullTint;
            figures.ink95 = double(below) < 0.95 * double(inked) ? figures.mostInk : figures.ink95;
        }
        below += count;
        figures.areaAbove += sum > mostWithin(limit) ? pixelArea * double(count) : 0;
    }
    return figures;
}

QString figuresTable(const InkFigures& figures, int passes) {
    QString table =
        passes > 1 ? QStringLiteral("figures of one pass of %1\n").arg(passes) : QString();
    table += QStringLiteral("%1 %2 %3 %4\n")
                 .arg(QStringLiteral("plate"), -16)
                 .arg(QStringLiteral("full tint mm²"), 14)
                 .arg(QStringLiteral("inked mm²"), 12)
                 .arg(QStringLiteral("largest %"), 10);
    for (const PlateFigures& one : figures.plates) {
        table += QStringLiteral("%1 %2 %3 %4\n")
                     .arg(one.plate.ink, -16)
                     .arg(one.fullTintArea, 14, 'f', 1)
                     .arg(one.inkedArea, 12, 'f', 1)
                     .arg(percent(one.mostTint), 10);
    }
    table +=
        QStringLiteral("total ink: largest %1 %, 95 % of the inked film below %2 %; all plates "
                       "%3 %\n")
            .arg(percent(figures.mostInk), percent(figures.ink95),
                 percent(figures.mostOfAllPlates));
    if (figures.limit) {
        table += QStringLiteral("above the limit of %1 %: %2 mm², %3 % of the inked film\n")
                     .arg(percent(*figures.limit))
                     .arg(figures.areaAbove, 0, 'f', 1)
                     .arg(100 * figures.shareAbove(), 0, 'f', 2);
    }
    return table;
}

QJsonObject figuresJson(const InkFigures& figures) {
    QJsonArray plates;
    for (std::size_t i = 0; i < figures.plates.size(); ++i) {
        const PlateFigures& one = figures.plates[i];
        plates.append(QJsonObject{{"ink", one.plate.ink},
                                  {"file", fileName(i + 1, one.plate.ink)},
                                  {"white", one.plate.isWhite},
                                  {"full_tint_mm2", one.fullTintArea},
                                  {"inked_mm2", one.inkedArea},
                                  {"largest", one.mostTint}});
    }
    return {{"plates", plates},
            {"inked_mm2", figures.inkedArea},
            {"total_ink_largest", figures.mostInk},
            {"total_ink_p95", figures.ink95},
            {"all_plates_largest", figures.mostOfAllPlates},
            {"limit", figures.limit ? QJsonValue(*figures.limit) : QJsonValue()},
            {"above_limit_mm2", figures.areaAbove},
            {"above_limit_share", figures.shareAbove()}};
}

int tintAt(const Plates& plates, int channel, QPoint pixel) {
    return channel < 4 ? processRow(plates, pixel.y())[4 * pixel.x() + channel]
                       : spotRow(plates, std::size_t(channel - 4), pixel.y())[pixel.x()];
}

double inkAt(const Plates& plates, QPoint pixel) {
    return double(sumOf(processRow(plates, pixel.y()) + 4 * pixel.x())) / fullTint;
}

Plates reducedPlates(const Plates& plates, int factor) {
    if (factor <= 1) {
        return plates;
    }
    const QSize size(std::max(1, plates.size.width() / factor),
                     std::max(1, plates.size.height() / factor));
    Plates small{size, QByteArray(qsizetype(4) * size.width() * size.height(), '\0'), plates.spots};
    for (SpotPlate& spot : small.spots) {
        spot.tint = QByteArray(qsizetype(size.width()) * size.height(), '\0');
    }
    const auto mean = [&](int channel, int x, int y) {
        int sum = 0, count = 0;
        for (int row = y * factor; row < std::min((y + 1) * factor, plates.size.height()); ++row) {
            for (int column = x * factor; column < std::min((x + 1) * factor, plates.size.width());
                 ++column, ++count) {
                sum += tintAt(plates, channel, {column, row});
            }
        }
        return char((sum + count / 2) / count);
    };
    std::vector<char*> targets{small.cmyk.data()};
    for (SpotPlate& spot : small.spots) {
        targets.push_back(spot.tint.data());
    }
    parallelFor(0, size.height(), [&](int y) {
        for (int x = 0; x < size.width(); ++x) {
            const qsizetype at = qsizetype(y) * size.width() + x;
            for (int ink = 0; ink < 4; ++ink) {
                targets[0][4 * at + ink] = mean(ink, x, y);
            }
            for (std::size_t spot = 0; spot < small.spots.size(); ++spot) {
                targets[1 + spot][at] = mean(4 + int(spot), x, y);
            }
        }
    });
    return small;
}

QImage greyPlate(const Plates& plates, int channel) {
    QImage grey(plates.size, QImage::Format_Grayscale8);
    uchar* const bits = grey.bits();
    const qsizetype stride = grey.bytesPerLine();
    parallelFor(0, grey.height(), [&](int y) {
        for (int x = 0; x < plates.size.width(); ++x) {
            bits[y * stride + x] = uchar(fullTint - tintAt(plates, channel, {x, y}));
        }
    });
    return grey;
}

QImage composite(const Plates& plates, const PrinterColour& colour,
                 const std::vector<bool>& isShown, const QColor& ground) {
    QByteArray inks = plates.cmyk;
    for (int ink = 0; ink < 4; ++ink) {
        if (!isShown[std::size_t(ink)]) {
            for (qsizetype byte = ink; byte < inks.size(); byte += 4) {
                inks[byte] = '\0';
            }
        }
    }
    QImage print = colour.screen(inks, plates.size);
    std::vector<ProofPlate> spots;
    for (const ProofPlate& plate : proofPlates(plates, colour)) {
        if (plate.channel >= 4 && isShown[std::size_t(plate.channel)]) {
            spots.push_back(plate);
        }
    }
    const bool coversNothing = std::all_of(spots.begin(), spots.end(),
                                           [](const ProofPlate& spot) { return spot.isWhite; });
    if (ground.rgb() != QColor(Qt::white).rgb() || !coversNothing) {
        addSpots(print, plates, spots, ground);
    }
    return print;
}

QColor totalInkColour(double ink, const std::optional<double>& limit) {
    if (std::lround(ink * fullTint) > mostWithin(limit)) {
        return {0xe0, 0x10, 0x30};
    }
    const double share = std::clamp(ink / limit.value_or(4), 0.0, 1.0);
    const auto mixed = [&](int dark) { return int(std::lround(255 + share * (dark - 255))); };
    return {mixed(0x08), mixed(0x1c), mixed(0x50)};
}

QImage totalInkMap(const Plates& plates, const std::optional<double>& limit) {
    std::array<QRgb, mostSum + 1> colours{};
    for (int sum = 0; sum <= mostSum; ++sum) {
        colours[std::size_t(sum)] = totalInkColour(double(sum) / fullTint, limit).rgb();
    }
    QImage map(plates.size, QImage::Format_RGB32);
    uchar* const bits = map.bits();
    const qsizetype stride = map.bytesPerLine();
    parallelFor(0, map.height(), [&](int y) {
        auto* const pixels = reinterpret_cast<QRgb*>(bits + y * stride);
        const uchar* inks = processRow(plates, y);
        for (int x = 0; x < plates.size.width(); ++x, inks += 4) {
            pixels[x] = colours[std::size_t(sumOf(inks))];
        }
    });
    return map;
}

SeparationProof separationProof(const Sheet& sheet, const PrintCorrection& correction) {
    const Plates plates = separate(sheet, correction);
    const InkFigures figures =
        inkFigures(plates, *correction.colour, {sheet.filmWidth.value(), sheet.filmHeight.value()},
                   correction.totalInk);
    std::vector<ProofFile> files;
    const auto addPicture = [&](QImage picture, const QString& name) {
        const int dotsPerMetre =
            int(std::lround(pixelsPerMillimetre(sheet.settings.resolution) * 1000));
        picture.setDotsPerMeterX(dotsPerMetre);
        picture.setDotsPerMeterY(dotsPerMetre);
        files.push_back({name, pngBytes(picture, name)});
    };
    for (std::size_t i = 0; i < figures.plates.size(); ++i) {
        const ProofPlate& plate = figures.plates[i].plate;
        addPicture(greyPlate(plates, plate.channel), fileName(i + 1, plate.ink));
    }
    addPicture(totalInkMap(plates, correction.totalInk), QStringLiteral("total-ink.png"));
    addPicture(composite(plates, *correction.colour,
                         std::vector<bool>(std::size_t(plates.channels()), true)),
               QStringLiteral("composite.png"));
    QJsonObject json = figuresJson(figures);
    json["job"] = sheet.job.hash;
    json["dpi"] = sheet.settings.resolution.value();
    json["passes"] = sheet.passes;
    files.push_back({QStringLiteral("plates.json"), QJsonDocument(json).toJson()});
    return {figures, files};
}

} // namespace dipwright
