// Qt draws the page; qpdf then makes a file of it that is exact and always the same: the page to a
// fraction of a point, no scaling in print dialogs, an output intent, and dates and identifiers
// that come from the content instead of the clock.
#include "sheet/Sheet.h"

#include "base/Error.h"

#include <QBuffer>
#include <QColorSpace>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPdfWriter>
#include <cmath>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

constexpr int dotsPerInch = 1200; // of the drawing's coordinates; the image keeps its own

QByteArray drawnPdf(const Sheet& sheet, QSizeF page) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    // Qt rounds pages to whole points; room for all of the page now, the exact box by qpdf.
    const QSizeF points(std::ceil(page.width() / millimetresPerInch * 72),
                        std::ceil(page.height() / millimetresPerInch * 72));
    writer.setPageLayout(
        QPageLayout(QPageSize(points, QPageSize::Point, QString(), QPageSize::ExactMatch),
                    QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
    writer.setResolution(dotsPerInch);
    writer.setTitle(sheet.job.project.simplified());
    writer.setCreator(QStringLiteral("Dipwright " DIPWRIGHT_VERSION));
    QPainter painter(&writer);
    const double scale = dotsPerInch / millimetresPerInch;
    painter.scale(scale, scale);
    paintSheet(painter, sheet);
    painter.end();
    return buffer.data();
}

// The page's box is measured from Qt's upper left corner, where the drawing starts.
void setExactPage(QPDF& pdf, QSizeF page) {
    QPDFObjectHandle object = QPDFPageDocumentHelper(pdf).getAllPages().at(0).getObjectHandle();
    const double top = object.getKey("/MediaBox").getArrayAsRectangle().ury;
    const double width = page.width() / millimetresPerInch * 72;
    const double height = page.height() / millimetresPerInch * 72;
    object.replaceKey("/MediaBox",
                      QPDFObjectHandle::newFromRectangle({0, top - height, width, top}));
}

void addOutputIntent(QPDF& pdf) {
    const QByteArray profile = QColorSpace(QColorSpace::SRgb).iccProfile();
    QPDFObjectHandle stream = QPDFObjectHandle::newStream(&pdf, profile.toStdString());
    stream.getDict().replaceKey("/N", QPDFObjectHandle::newInteger(3));
    QPDFObjectHandle intent = QPDFObjectHandle::parse(
        "<< /Type /OutputIntent /S /GTS_PDFX /OutputConditionIdentifier (sRGB IEC61966-2.1)"
        " /Info (sRGB IEC61966-2.1) >>");
    intent.replaceKey("/DestOutputProfile", stream);
    QPDFObjectHandle intents = QPDFObjectHandle::newArray();
    intents.appendItem(pdf.makeIndirectObject(intent));
    pdf.getRoot().replaceKey("/OutputIntents", intents);
}

QByteArray finishedPdf(const QByteArray& drawn, QSizeF page) {
    QPDF pdf;
    pdf.processMemoryFile("sheet.pdf", drawn.constData(), size_t(drawn.size()));
    setExactPage(pdf, page);
    addOutputIntent(pdf);
    pdf.getRoot().replaceKey("/ViewerPreferences",
                             QPDFObjectHandle::parse("<< /PrintScaling /None >>"));
    pdf.getTrailer().getKey("/Info").removeKey("/CreationDate");
    pdf.getTrailer().getKey("/Info").removeKey("/ModDate");
    QPDFWriter writer(pdf);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.setStreamDataMode(qpdf_s_preserve);
    writer.setMinimumPDFVersion("1.6"); // the first with PrintScaling
    writer.write();
    const std::shared_ptr<Buffer> bytes = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char*>(bytes->getBuffer()), qsizetype(bytes->getSize())};
}

} // namespace

void writeSheetPdf(const Sheet& sheet, QIODevice& device) {
    const QSizeF page = pageSize(sheet);
    const QByteArray pdf = finishedPdf(drawnPdf(sheet, page), page);
    if (device.write(pdf) != pdf.size()) {
        throw Error(Text::tr("The sheet's PDF cannot be written: %1").arg(device.errorString()),
                    QStringLiteral("sheet.pdf"));
    }
}

} // namespace dipwright
