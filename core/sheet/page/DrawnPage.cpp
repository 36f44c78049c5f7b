#include "sheet/page/DrawnPage.h"

#include "base/Bytes.h"
#include "base/Png.h"
#include "sheet/page/Sheet.h"
#include "sheet/pdf/PdfDocument.h"

#include <QCoreApplication>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::DrawnPage)
};

} // namespace

void writeDrawnPdf(const DrawnPage& page, QIODevice& device) {
    PdfSettings settings;
    settings.title = page.title;
    if (!page.inks.isEmpty()) {
        settings.outputProfile = page.inks;
        settings.outputName = page.inksName;
        settings.inks = std::make_shared<const PackedPlates>(); // plates without a picture
    }
    const auto paint = [&](QPainter& painter) {
        correctScale(painter, page.paper, {page.scaleX, page.scaleY});
        page.paint(painter);
    };
    const QByteArray pdf = pdfDocument({{page.paper, paint}}, settings);
    writeTo(device, pdf, Text::tr("The page cannot be written: %1"), QStringLiteral("PDF"));
}

void writeDrawnPng(const DrawnPage& page, DotsPerInch resolution, QIODevice& device) {
    QImage image(
        sheetPixels(Millimetres(page.paper.width()), Millimetres(page.paper.height()), resolution),
        QImage::Format_RGB888);
    image.fill(Qt::white);
    image.setDotsPerMeterX(int(std::lround(resolution.value() / millimetresPerInch * 1000)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QPainter painter(&image);
    painter.scale(pixelsPerMillimetre(resolution), pixelsPerMillimetre(resolution));
    correctScale(painter, page.paper, {page.scaleX, page.scaleY});
    page.paint(painter);
    painter.end();
    writePng(image, device, page.title);
}

} // namespace dipwright
