#include "PaperMeasure.h"

#include "base/Units.h"

#include <QDebug>
#include <QImageReader>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTransform>

namespace dipwright {

QByteArray output(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(60000) || process.exitCode() != 0) {
        qWarning() << program << arguments << process.errorString()
                   << process.readAllStandardError();
        return {};
    }
    return process.readAllStandardOutput();
}

QSizeF pdfPage(const QString& path, int page) {
    const QString number = QString::number(page);
    const QString info = QString::fromUtf8(output("pdfinfo", {"-f", number, "-l", number, path}));
    const auto match = QRegularExpression("size: *([0-9.]+) x ([0-9.]+) pts").match(info);
    return QSizeF(match.captured(1).toDouble(), match.captured(2).toDouble()) / 72 *
           millimetresPerInch;
}

QString pdfWords(const QString& path, int page) {
    const QString number = QString::number(page);
    return QString::fromUtf8(
        output("pdftotext", {"-layout", "-f", number, "-l", number, path, "-"}));
}

QImage renderedPage(const QString& path, int dpi, const QRectF& box, int page) {
    QImageReader::setAllocationLimit(1024); // MB, a page at 600 dpi
    const QTemporaryDir folder;
    const QString base = folder.filePath("page");
    const QRect pixels = QTransform::fromScale(dpi / millimetresPerInch, dpi / millimetresPerInch)
                             .mapRect(box)
                             .toAlignedRect();
    output("pdftoppm",
           {"-r", QString::number(dpi), "-f", QString::number(page), "-l", QString::number(page),
            "-gray", "-png", "-singlefile", "-x", QString::number(pixels.x()), "-y",
            QString::number(pixels.y()), "-W", QString::number(pixels.width()), "-H",
            QString::number(pixels.height()), path, base});
    return QImage(base + ".png").convertToFormat(QImage::Format_Grayscale8);
}

std::vector<double> edges(const QImage& grey, int row, int margin) {
    std::vector<double> found;
    const uchar* line = grey.constScanLine(row);
    int start = margin; // last pixel that is fully light or dark
    double light = 0;   // sum of the light in the pixels after `start`
    for (int x = margin; x < grey.width() - margin; ++x) {
        if (line[x] > 5 && line[x] < 250) {
            light += line[x] / 255.0;
            continue;
        }
        if ((line[x] < 128) != (line[start] < 128)) {
            found.push_back(start + 1 + (line[x] < 128 ? light : x - start - 1 - light));
        }
        start = x;
        light = 0;
    }
    return found;
}

std::vector<double> darkMiddles(const QImage& grey, bool alongRow, int at) {
    std::vector<double> found;
    double weight = 0;
    double sum = 0;
    const int length = alongRow ? grey.width() : grey.height();
    for (int i = 0; i < length; ++i) {
        const int dark = 255 - qGray(alongRow ? grey.pixel(i, at) : grey.pixel(at, i));
        if (dark > 5) {
            weight += dark;
            sum += dark * (i + 0.5);
        } else if (weight > 0) {
            found.push_back(sum / weight);
            weight = sum = 0;
        }
    }
    return found;
}

} // namespace dipwright
