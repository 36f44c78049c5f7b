#include "sheet/pdf/DrawnPdf.h"

#include "base/ProgramName.h"
#include "base/Units.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPdfWriter>
#include <cmath>

namespace dipwright {
namespace {

constexpr int dotsPerInch = 1200; // resolution of the drawing's coordinates, not of its images

class Writer : public QPdfWriter {
public:
    Writer(QIODevice* device, bool imagesLater) : QPdfWriter(device), areImagesLater(imagesLater) {}
    const bool areImagesLater;
};

// Qt rounds pages to whole points. This page is rounded up; qpdf later sets the exact box.
QPageLayout roomFor(QSizeF page) {
    const QSizeF exact = inPoints(page);
    const QSizeF size(std::ceil(exact.width()), std::ceil(exact.height()));
    return {QPageSize(size, QPageSize::Point, QString(), QPageSize::ExactMatch),
            QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)};
}

} // namespace

QSizeF inPoints(QSizeF millimetres) {
    return millimetres / millimetresPerInch * 72;
}

bool drawsImagesLater(const QPainter& painter) {
    const auto* const writer = dynamic_cast<const Writer*>(painter.device());
    return writer && writer->areImagesLater;
}

QByteArray drawnPdf(const std::vector<PdfPage>& pages, const QString& title, bool imagesLater) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    Writer writer(&buffer, imagesLater);
    writer.setResolution(dotsPerInch);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Dipwright ") + programVersion());
    writer.setPageLayout(roomFor(pages.front().size));
    QPainter painter(&writer);
    for (const PdfPage& page : pages) {
        if (&page != &pages.front()) {
            writer.setPageLayout(roomFor(page.size));
            writer.newPage();
        }
        const double unit = dotsPerInch / millimetresPerInch;
        painter.resetTransform();
        painter.scale(unit, unit);
        page.paint(painter);
    }
    painter.end();
    return buffer.data();
}

} // namespace dipwright
