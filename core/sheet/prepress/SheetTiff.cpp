#include "sheet/prepress/SheetFiles.h"

#include "base/Error.h"
#include "base/ProgramName.h"
#include "base/WideGamut.h"
#include "sheet/page/SheetInk.h"
#include "sheet/page/SheetRows.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/ScaledRows.h"
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

// A file to which libtiff writes.
class TiffFile {
public:
    // `mode`: "w" for a file of up to 4 GB, "w8" for BigTIFF.
    TiffFile(QIODevice& device, const char* mode) : device_(device), start_(device.pos()) {
        TIFFSetErrorHandler(nullptr); // the caller reports failures
        tiff_ = TIFFClientOpen("sheet.tiff", mode, this, read, write, seek, close, size, nullptr,
                               nullptr);
    }
    ~TiffFile() { finish(); }
    TiffFile(const TiffFile&) = delete;
    TiffFile& operator=(const TiffFile&) = delete;

    TIFF* tiff() const { return tiff_; }
    // Writes what remains. Returns whether the device has taken everything.
    bool finish() {
        if (tiff_) {
            TIFFClose(tiff_);
            tiff_ = nullptr;
        }
        return isGood_;
    }
    bool isGood() const { return isGood_; }

private:
    static TiffFile& self(thandle_t handle) { return *static_cast<TiffFile*>(handle); }
    static tmsize_t read(thandle_t, void*, tmsize_t) { return 0; } // new files are not read
    static tmsize_t write(thandle_t handle, void* source, tmsize_t count) {
        TiffFile& file = self(handle);
        const qint64 written = file.device_.write(static_cast<const char*>(source), count);
        file.end_ = std::max(file.end_, file.device_.pos() - file.start_);
        file.isGood_ = file.isGood_ && written == count;
        return tmsize_t(written);
    }
    static toff_t seek(thandle_t handle, toff_t offset, int from) {
        TiffFile& file = self(handle);
        const qint64 base = from == SEEK_SET   ? 0
                            : from == SEEK_CUR ? file.device_.pos() - file.start_
                                               : file.end_;
        const qint64 at = base + qint64(offset);
        file.isGood_ = file.device_.seek(file.start_ + at) && file.isGood_;
        return toff_t(at);
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return toff_t(self(handle).end_); }

    QIODevice& device_;
    qint64 start_, end_ = 0; // `end_` counts from `start_`
    bool isGood_ = true;
    TIFF* tiff_ = nullptr;
};

constexpr int stripBytes = 1 << 20; // pixels of one TIFF strip before compression

struct Resolution {
    DotsPerInch x, y;
};

// Declares the inks. TIFF 6.0 (section 16) names inks only for ink sets other than CMYK. The names
// follow each other, each ending with a zero byte.
void setInks(TIFF* tiff, const std::vector<SheetPlate>& spots) {
    TIFFSetField(tiff, TIFFTAG_INKSET, spots.empty() ? INKSET_CMYK : INKSET_MULTIINK);
    if (!spots.empty()) {
        QByteArray names("Cyan\0Magenta\0Yellow\0Black\0", 26);
        for (const SheetPlate& spot : spots) {
            names += spot.name.toUtf8() + '\0';
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

// How a page lies on the pixels of its file.
struct PagePixels {
    QSize page;
    QRect film;
    double unitX = 1, unitY = 1; // pixels per mm of the page
    Resolution resolution;
};

PagePixels pagePixels(const Sheet& sheet, const SheetLayout& layout,
                      const PrintCorrection& correction) {
    const DotsPerInch dpi = sheet.settings.resolution;
    const double unit = pixelsPerMillimetre(dpi);
    PagePixels pixels{{}, {{}, filmPixels(sheet)}, unit, unit, {}};
    pixels.resolution = {dpi * correction.scaleX, dpi * correction.scaleY};
    if (correction.squarePixels && correction.scaleX != correction.scaleY) {
        pixels.unitX /= correction.scaleX;
        pixels.unitY /= correction.scaleY;
        pixels.resolution = {dpi, dpi};
        pixels.film.setSize({int(std::lround(pixels.film.width() / correction.scaleX)),
                             int(std::lround(pixels.film.height() / correction.scaleY))});
    }
    pixels.film.moveTopLeft(
        QPointF(layout.film.left() * pixels.unitX, layout.film.top() * pixels.unitY).toPoint());
    pixels.page = {int(std::lround(layout.page.width() * pixels.unitX)),
                   int(std::lround(layout.page.height() * pixels.unitY))};
    if (pixels.page.width() > mostSheetPixels) {
        sheetPixels(Millimetres(layout.page.width()), Millimetres(layout.page.height()), dpi);
    }
    return pixels;
}

// Makes the rows of a page, from top to bottom.
class PageRows {
public:
    PageRows(const Sheet& sheet, const PrintCorrection& correction)
        : sheet_(sheet), correction_(correction), layout_(sheetLayout(sheet)),
          pixels_(pagePixels(sheet, layout_, correction)),
          across_(filmPixels(sheet).width(), pixels_.film.width()),
          down_(filmPixels(sheet).height(), pixels_.film.height()) {
        if (correction.colour && correction.colour->isCmyk()) {
            inks_ = std::make_unique<const RowSeparation>(sheet, correction);
        }
    }

    const PagePixels& pixels() const { return pixels_; }
    int channels() const { return inks_ ? 4 + int(sheet_.plates.size()) : 3; }
    bool isCmyk() const { return inks_ != nullptr; }
    // Returns the rows first … end - 1, pixel by pixel.
    QByteArray rows(int first, int end) const {
        return inks_ ? inkedRows(first, end) : rgbRows(first, end);
    }

private:
    bool isScaled() const { return pixels_.film.size() != filmPixels(sheet_); }

    // Returns the rows of the film that lie on these rows of the page, counted on the film; first
    // and end are the same if there are none.
    std::pair<int, int> filmRows(int first, int end) const {
        const int height = pixels_.film.height();
        const int begin = std::clamp(first - pixels_.film.top(), 0, height);
        return {begin, std::clamp(end - pixels_.film.top(), begin, height)};
    }

    // Returns rows of the film's image on white, at the page's resolution.
    QImage filmImage(int first, int end) const {
        const auto original = [&](int from, int to) {
            return onWhitePaper(sheetRows(sheet_, from, to).image);
        };
        return !isScaled()              ? original(first, end)
               : isWide(original(0, 1)) ? scaledImage<std::uint16_t>(original, 4, first, end)
                                        : scaledImage<uchar>(original, 3, first, end);
    }
    template <typename Sample, typename Original>
    QImage scaledImage(const Original& original, int channels, int first, int end) const {
        QImage image;
        const auto source = [&](int from, int to) {
            const QImage rows = original(from, to);
            image = rows;
            SampleRows<Sample> samples;
            for (int y = 0; y < rows.height(); ++y) {
                const auto* row = reinterpret_cast<const Sample*>(rows.constScanLine(y));
                samples.insert(samples.end(), row, row + qsizetype(rows.width()) * channels);
            }
            return samples;
        };
        const SampleRows<Sample> samples =
            scaledRows<Sample>(across_, down_, channels, first, end, source);
        QImage scaled(pixels_.film.width(), end - first, image.format());
        scaled.setColorSpace(image.colorSpace());
        const qsizetype row = qsizetype(scaled.width()) * channels;
        for (int y = 0; y < scaled.height(); ++y) {
            std::memcpy(scaled.scanLine(y), samples.data() + y * row,
                        std::size_t(row) * sizeof(Sample));
        }
        return scaled;
    }

    // Returns rows of the film's plates at the page's resolution.
    Plates filmPlates(int first, int end) const {
        if (!isScaled()) {
            return inks_->plates(first, end);
        }
        Plates original;
        const auto scaled = [&](const QByteArray& plate, int channels) {
            const SampleRows<uchar> samples =
                scaledRows<uchar>(across_, down_, channels, first, end, [&](int, int) {
                    return SampleRows<uchar>(plate.begin(), plate.end());
                });
            return QByteArray(reinterpret_cast<const char*>(samples.data()),
                              qsizetype(samples.size()));
        };
        original = inks_->plates(down_[first].from.front(), down_[end - 1].from.back() + 1);
        Plates plates{{pixels_.film.width(), end - first}, scaled(original.cmyk, 4), {}};
        if (correction_.totalInk) {
            limitInk(plates.cmyk, *correction_.totalInk);
        }
        for (const SpotPlate& spot : original.spots) {
            plates.spots.push_back({spot.ink, spot.first, scaled(spot.tint, 1)});
        }
        return plates;
    }

    // Paints the marks. The painter's origin is the left end of row `first` of the page.
    void addMarks(QImage& image, int first) const {
        constexpr double markReachMost = 15; // mm that marks stand beyond a piece's box
        const QRectF near =
            QRectF(0, first / pixels_.unitY, layout_.page.width(), image.height() / pixels_.unitY)
                .adjusted(0, -markReachMost, 0, markReachMost);
        SheetLayout layout = layout_;
        std::erase_if(layout.pieces,
                      [&](const SheetPiece& piece) { return !piece.box().intersects(near); });
        QPainter painter(&image);
        painter.translate(0, -first);
        painter.scale(pixels_.unitX, pixels_.unitY);
        paintMarks(painter, layout);
    }

    QByteArray rgbRows(int first, int end) const {
        const auto [from, to] = filmRows(first, end);
        const QImage film = filmImage(from == to ? 0 : from, from == to ? 1 : to);
        QImage page(pixels_.page.width(), end - first, film.format());
        page.setColorSpace(film.colorSpace());
        page.fill(Qt::white);
        if (from < to) {
            QPainter(&page).drawImage(pixels_.film.left(), pixels_.film.top() + from - first, film);
        }
        addMarks(page, first);
        page = correction_.colour ? correction_.colour->rgb(page) : inSrgb(page);
        QByteArray bytes;
        bytes.reserve(qsizetype(page.width()) * page.height() * 3);
        for (int y = 0; y < page.height(); ++y) {
            bytes.append(reinterpret_cast<const char*>(page.constScanLine(y)),
                         qsizetype(page.width()) * 3);
        }
        return bytes;
    }

    // Marks are added in black ink alone, because hairlines in four inks blur if the plates do not
    // register exactly. Their white rim removes the film's inks.
    QByteArray inkedRows(int first, int end) const {
        QByteArray inks = platesOnPage(first, end);
        QImage marks(pixels_.page.width(), end - first, QImage::Format_ARGB32_Premultiplied);
        marks.fill(Qt::transparent);
        addMarks(marks, first);
        auto* ink = reinterpret_cast<uchar*>(inks.data());
        for (int y = 0; y < marks.height(); ++y) {
            const auto* row = reinterpret_cast<const QRgb*>(marks.constScanLine(y));
            for (int x = 0; x < marks.width(); ++x, ink += channels()) {
                const int cover = qAlpha(row[x]);
                if (cover == 0) {
                    continue;
                }
                for (int channel = 0; channel < channels(); ++channel) {
                    ink[channel] = uchar((ink[channel] * (255 - cover) + 127) / 255);
                }
                const int black =
                    cover - qRed(row[x]); // the colour is premultiplied, so white equals `cover`
                ink[3] = uchar(std::min(255, ink[3] + black));
            }
        }
        return inks;
    }

    // Returns rows of the film's plates on the page, one byte per plate.
    QByteArray platesOnPage(int first, int end) const {
        const int width = pixels_.page.width();
        QByteArray bytes(qsizetype(width) * (end - first) * channels(), '\0');
        const std::array<char, 4> bare = bareInks(*correction_.colour);
        for (qsizetype pixel = 0; pixel < bytes.size(); pixel += channels()) {
            std::copy(bare.begin(), bare.end(), bytes.begin() + pixel);
        }
        const auto [from, to] = filmRows(first, end);
        if (from == to) {
            return bytes;
        }
        const Plates plates = filmPlates(from, to);
        const int right = std::min(pixels_.film.width(), width - pixels_.film.left());
        for (int y = 0; y < to - from; ++y) {
            const qsizetype row = qsizetype(pixels_.film.top() + from + y - first) * width;
            char* pixel = bytes.data() + (row + pixels_.film.left()) * channels();
            qsizetype place = qsizetype(y) * plates.size.width();
            for (int x = 0; x < right; ++x, ++place, pixel += channels()) {
                std::copy_n(plates.cmyk.constData() + 4 * place, 4, pixel);
                for (std::size_t spot = 0; spot < plates.spots.size(); ++spot) {
                    pixel[4 + spot] = plates.spots[spot].tint[place];
                }
            }
        }
        return bytes;
    }

    const Sheet& sheet_;
    const PrintCorrection& correction_;
    SheetLayout layout_;
    PagePixels pixels_;
    ScaledSide across_, down_;
    std::unique_ptr<const RowSeparation> inks_; // null: RGB
};

// Writes the page. Returns whether libtiff has taken all rows.
bool writeRows(TIFF* tiff, const Sheet& sheet, const PrintCorrection& correction) {
    constexpr int pixelsAtOnce = 1 << 22;
    const PageRows page(sheet, correction);
    const QSize size = page.pixels().page;
    setTags(tiff, size, page.channels(), page.pixels().resolution,
            correction.colour ? correction.colour->iccProfile()
                              : QColorSpace(QColorSpace::SRgb).iccProfile());
    if (page.isCmyk()) {
        setInks(tiff, sheet.plates);
    }
    const int step = std::max(pixelsAtOnce / size.width(), 1);
    for (int first = 0; first < size.height(); first += step) {
        const int end = std::min(first + step, size.height());
        QByteArray rows = page.rows(first, end);
        for (int y = first; y < end; ++y) { // libtiff writes to the rows
            char* row = rows.data() + qsizetype(y - first) * size.width() * page.channels();
            if (TIFFWriteScanline(tiff, row, std::uint32_t(y), 0) != 1) {
                return false;
            }
        }
    }
    return TIFFFlush(tiff) == 1; // writes the last strip
}

} // namespace

void writeSheetTiff(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction) {
    const qint64 start = device.pos();
    for (const char* mode : {"w", "w8"}) { // BigTIFF only if the file is too large without
        device.seek(start);
        TiffFile file(device, mode);
        const bool isOpen = file.tiff() != nullptr;
        const bool isComplete = isOpen && writeRows(file.tiff(), sheet, correction);
        if (isOpen && file.isGood() && !isComplete && mode[1] == '\0') {
            continue;
        }
        if (!file.finish() || !isComplete) {
            throw Error(
                Text::tr("The sheet's TIFF cannot be written: %1").arg(device.errorString()),
                QStringLiteral("sheet.tiff"));
        }
        return;
    }
}

} // namespace dipwright
