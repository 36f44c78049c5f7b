#include "sheet/prepress/SheetFiles.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "base/ImageRows.h"
#include "base/Png.h"
#include "base/ProgramName.h"
#include "base/WideGamut.h"
#include "sheet/page/SheetInk.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tiffio.h>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

QSize pagePixels(const Sheet& sheet, const SheetLayout& layout) {
    return sheetPixels(Millimetres(layout.page.width()), Millimetres(layout.page.height()),
                       sheet.settings.resolution);
}

// Returns the film on its page, without marks.
QImage filmOnPage(const Sheet& sheet, const SheetLayout& layout) {
    const QImage film = onWhitePaper(sheet.image);
    QImage page(pagePixels(sheet, layout), film.format());
    page.fill(Qt::white);
    QPainter painter(&page);
    const double unit = pixelsPerMillimetre(sheet.settings.resolution);
    painter.drawImage((layout.film.topLeft() * unit).toPoint(), film);
    return page;
}

void addMarks(QImage& page, const Sheet& sheet, const SheetLayout& layout) {
    QPainter painter(&page);
    const double unit = pixelsPerMillimetre(sheet.settings.resolution);
    painter.scale(unit, unit);
    paintMarks(painter, layout);
}

// Returns the page's pixels at the sheet's resolution, in the printer's RGB.
QByteArray rgbPage(const Sheet& sheet, const SheetLayout& layout, const PrinterColour* colour) {
    QImage page = filmOnPage(sheet, layout);
    addMarks(page, sheet, layout);
    page = colour ? colour->rgb(page) : inSrgb(page);
    QByteArray bytes;
    bytes.reserve(qsizetype(page.width()) * page.height() * 3);
    for (int y = 0; y < page.height(); ++y) {
        bytes.append(reinterpret_cast<const char*>(page.constScanLine(y)),
                     qsizetype(page.width()) * 3);
    }
    return bytes;
}

// Returns the film's plates on its page, moved to whole pixels. Each pixel has one byte per plate.
QByteArray platesOnPage(const Plates& plates, const std::array<char, 4>& bare, QSize page,
                        QPoint corner) {
    const int channels = plates.channels();
    QByteArray bytes(qsizetype(page.width()) * page.height() * channels, '\0');
    char* pixel = bytes.data();
    for (int y = 0; y < page.height(); ++y) {
        for (int x = 0; x < page.width(); ++x, pixel += channels) {
            const QPoint at = QPoint(x, y) - corner;
            if (!QRect(QPoint(), plates.size).contains(at)) {
                std::copy(bare.begin(), bare.end(), pixel);
                continue;
            }
            const qsizetype place = qsizetype(at.y()) * plates.size.width() + at.x();
            std::copy_n(plates.cmyk.constData() + 4 * place, 4, pixel);
            char* spot = pixel + 4;
            for (const SpotPlate& plate : plates.spots) {
                *spot++ = plate.tint[place];
            }
        }
    }
    return bytes;
}

// Returns the page in the printer's inks. Marks are added in black ink alone, because hairlines in
// four inks blur if the plates do not register exactly. Their white rim removes the film's inks.
QByteArray inkedPage(const Sheet& sheet, const SheetLayout& layout, const Plates& plates,
                     const PrinterColour& colour) {
    const double unit = pixelsPerMillimetre(sheet.settings.resolution);
    const QSize page = pagePixels(sheet, layout);
    QByteArray inks =
        platesOnPage(plates, bareInks(colour), page, (layout.film.topLeft() * unit).toPoint());
    const int channels = plates.channels();
    QImage marks(page, QImage::Format_ARGB32_Premultiplied);
    marks.fill(Qt::transparent);
    addMarks(marks, sheet, layout);
    auto* ink = reinterpret_cast<uchar*>(inks.data());
    for (int y = 0; y < marks.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(marks.constScanLine(y));
        for (int x = 0; x < marks.width(); ++x, ink += channels) {
            const int cover = qAlpha(row[x]);
            if (cover == 0) {
                continue;
            }
            for (int channel = 0; channel < channels; ++channel) {
                ink[channel] = uchar((ink[channel] * (255 - cover) + 127) / 255);
            }
            const int black =
                cover - qRed(row[x]); // the colour is premultiplied, so white equals `cover`
            ink[3] = uchar(std::min(255, ink[3] + black));
        }
    }
    return inks;
}

// Memory to which libtiff writes a TIFF file.
class TiffBuffer {
public:
    TiffBuffer()
        : tiff_(TIFFClientOpen("sheet.tiff", "w", this, read, write, seek, close, size, nullptr,
                               nullptr)) {}
    ~TiffBuffer() { finish(); }
    TiffBuffer(const TiffBuffer&) = delete;
    TiffBuffer& operator=(const TiffBuffer&) = delete;

    TIFF* tiff() const { return tiff_; }
    const QByteArray& finish() {
        if (tiff_) {
            TIFFClose(tiff_);
            tiff_ = nullptr;
        }
        return bytes_;
    }

private:
    static TiffBuffer& self(thandle_t handle) { return *static_cast<TiffBuffer*>(handle); }
    static tmsize_t read(thandle_t handle, void* target, tmsize_t count) {
        TiffBuffer& buffer = self(handle);
        count = std::min<tmsize_t>(count, tmsize_t(buffer.bytes_.size() - buffer.at_));
        std::memcpy(target, buffer.bytes_.constData() + buffer.at_, std::size_t(count));
        buffer.at_ += count;
        return count;
    }
    static tmsize_t write(thandle_t handle, void* source, tmsize_t count) {
        TiffBuffer& buffer = self(handle);
        if (buffer.at_ + count > buffer.bytes_.size()) {
            buffer.bytes_.resize(buffer.at_ + count);
        }
        std::memcpy(buffer.bytes_.data() + buffer.at_, source, std::size_t(count));
        buffer.at_ += count;
        return count;
    }
    static toff_t seek(thandle_t handle, toff_t offset, int from) {
        TiffBuffer& buffer = self(handle);
        const qsizetype base = from == SEEK_SET   ? 0
                               : from == SEEK_CUR ? buffer.at_
                                                  : buffer.bytes_.size();
        buffer.at_ = base + qsizetype(offset);
        return toff_t(buffer.at_);
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return toff_t(self(handle).bytes_.size()); }

    QByteArray bytes_;
    qsizetype at_ = 0;
    TIFF* tiff_;
};

constexpr int stripBytes = 1 << 20; // pixels of one TIFF strip before compression

struct Resolution {
    DotsPerInch x, y;
};

// Declares the inks. TIFF 6.0 (section 16) names inks only for ink sets other than CMYK. The names
// follow each other, each ending with a zero byte.
void setInks(TIFF* tiff, const std::vector<SpotPlate>& spots) {
    TIFFSetField(tiff, TIFFTAG_INKSET, spots.empty() ? INKSET_CMYK : INKSET_MULTIINK);
    if (!spots.empty()) {
        QByteArray names("Cyan\0Magenta\0Yellow\0Black\0", 26);
        for (const SpotPlate& spot : spots) {
            names += spot.ink.name.toUtf8() + '\0';
        }
        TIFFSetField(tiff, TIFFTAG_NUMBEROFINKS, 4 + int(spots.size()));
        TIFFSetField(tiff, TIFFTAG_INKNAMES, std::uint32_t(names.size()), names.constData());
    }
}

void setTags(TIFF* tiff, QSize size, int channels, Resolution resolution, const QByteArray& icc) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, size.width());
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, size.height());
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, channels);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                 channels >= 4 ? PHOTOMETRIC_SEPARATED : PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, std::max(1, stripBytes / (size.width() * channels)));
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, resolution.x.value());
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, resolution.y.value());
    TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
    const QByteArray software = "Dipwright " + programVersion().toLatin1();
    TIFFSetField(tiff, TIFFTAG_SOFTWARE, software.constData());
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(icc.size()), icc.constData());
}

// Returns the compressed film image on white for RGB files: in the RGB of `colour`, or in sRGB if
// it is null.
PackedPixels packedFilm(const Sheet& sheet, const PrinterColour* colour) {
    const QImage& image = sheet.image;
    return packedPixels({image.size(), 3, 8, [&](int first, int end) {
                             const QImage rows = imageRows(image, first, end);
                             return flattened(colour ? colour->rgb(rows) : rows);
                         }});
}

} // namespace

PreparedSheet preparedSheet(const Sheet& sheet, const PrintCorrection& correction) {
    PreparedSheet prepared{sheet, {}};
    QStringList names{sheet.job.project.simplified(), sheet.job.immersion.simplified()};
    names.removeAll(QString());
    prepared.settings.title = names.join(QStringLiteral(" – ")); // each dip has its own title
    prepared.settings.date = sheet.job.date.simplified();
    if (correction.colour) {
        prepared.settings.outputProfile = correction.colour->iccProfile();
        prepared.settings.outputName = correction.colour->description();
        if (correction.colour->isCmyk()) {
            prepared.settings.inks = std::make_shared<const Plates>(separate(sheet, correction));
            return prepared;
        }
    }
    prepared.settings.picture =
        std::make_shared<const PackedPixels>(packedFilm(sheet, correction.colour));
    return prepared;
}

QByteArray sheetPng(const PreparedSheet& prepared) {
    const int dotsPerMetre =
        int(std::lround(pixelsPerMillimetre(prepared.sheet.settings.resolution) * 1000));
    return pngBytes(*prepared.settings.picture,
                    {dotsPerMetre, dotsPerMetre, QColorSpace(QColorSpace::SRgb)});
}

QByteArray sheetPdf(const PreparedSheet& prepared, const PrintCorrection& correction) {
    const auto paint = [&](QPainter& painter) {
        paintCorrectedSheet(painter, prepared.sheet, correction);
    };
    const QSizeF page = pageSize(prepared.sheet);
    const QSizeF paper = correction.acrossPaper ? page.transposed() : page;
    return pdfDocument({{paper, paint}}, prepared.settings);
}

void writeSheetPng(const Sheet& sheet, QIODevice& device) {
    writeTo(device, sheetPng(preparedSheet(sheet, {})),
            Text::tr("The sheet's PNG cannot be written: %1"), QStringLiteral("sheet.png"));
}

void writeSheetPdf(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction) {
    writeTo(device, sheetPdf(preparedSheet(sheet, correction), correction),
            Text::tr("The sheet's PDF cannot be written: %1"), QStringLiteral("sheet.pdf"));
}

void writeSheetTiff(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction) {
    const PrinterColour* colour = correction.colour;
    const DotsPerInch dpi = sheet.settings.resolution;
    const SheetLayout layout = sheetLayout(sheet);
    const QSize size = pagePixels(sheet, layout);
    const bool cmyk = colour && colour->isCmyk();
    const Plates plates = cmyk ? separate(sheet, correction) : Plates{};
    const int channels = cmyk ? plates.channels() : 3;
    QByteArray page =
        cmyk ? inkedPage(sheet, layout, plates, *colour) : rgbPage(sheet, layout, colour);
    TiffBuffer buffer;
    setTags(buffer.tiff(), size, channels, {dpi * correction.scaleX, dpi * correction.scaleY},
            colour ? colour->iccProfile() : QColorSpace(QColorSpace::SRgb).iccProfile());
    if (cmyk) {
        setInks(buffer.tiff(), plates.spots);
    }
    bool written = true;
    for (int y = 0; y < size.height() && written; ++y) {
        char* row = page.data() + qsizetype(y) * size.width() * channels; // libtiff writes to it
        written = TIFFWriteScanline(buffer.tiff(), row, std::uint32_t(y), 0) == 1;
    }
    const QByteArray& bytes = buffer.finish();
    if (!written || device.write(bytes) != bytes.size()) {
        throw Error(Text::tr("The sheet's TIFF cannot be written: %1").arg(device.errorString()),
                    QStringLiteral("sheet.tiff"));
    }
}

} // namespace dipwright
