#include "sheet/pdf/PdfDocument.h"

#include "base/Error.h"
#include "base/ProgramName.h"
#include "sheet/pdf/DrawnPdf.h"
#include "sheet/pdf/ImageObject.h"
#include "sheet/pdf/InkedPages.h"
#include "sheet/pdf/PdfX.h"

#include <QColorSpace>
#include <qpdf/Pl_Function.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace dipwright {
namespace {

// Sets the page's boxes to the exact size in points, measured from Qt's upper left corner, where
// the drawing starts.
void setExactBox(QPDFObjectHandle page, QSizeF size) {
    const double top = page.getKey("/MediaBox").getArrayAsRectangle().ury;
    for (const char* box : {"/MediaBox", "/TrimBox"}) {
        page.replaceKey(
            box, QPDFObjectHandle::newFromRectangle({0, top - size.height(), size.width(), top}));
    }
}

// Adds the output intent, which names the colour space of the pages. In a PDF/X document it is a
// PDF/X intent. Otherwise it is a PDF/A intent, because the profile is not a printer's.
void addOutputIntent(QPDF& pdf, const QByteArray& profile, const PdfSettings& settings) {
    QPDFObjectHandle stream = QPDFObjectHandle::newStream(&pdf, profile.toStdString());
    stream.getDict().replaceKey("/N", QPDFObjectHandle::newInteger(settings.inks ? 4 : 3));
    const QPDFObjectHandle name =
        QPDFObjectHandle::newUnicodeString(settings.outputName.toStdString());
    QPDFObjectHandle intent = QPDFObjectHandle::parse("<< /Type /OutputIntent >>");
    intent.replaceKey(
        "/S", QPDFObjectHandle::newName(isOutputDevice(profile) ? "/GTS_PDFX" : "/GTS_PDFA1"));
    intent.replaceKey("/OutputConditionIdentifier", name);
    intent.replaceKey("/Info", name);
    intent.replaceKey("/DestOutputProfile", stream);
    QPDFObjectHandle intents = QPDFObjectHandle::newArray();
    intents.appendItem(pdf.makeIndirectObject(intent));
    pdf.getRoot().replaceKey("/OutputIntents", intents);
}

// Gives the drawn RGB colours of all pages the profile `profile`. Otherwise a raster image
// processor would take them for colours of its own default space.
void setRgbSpace(QPDF& pdf, const QByteArray& profile) {
    QPDFObjectHandle stream = QPDFObjectHandle::newStream(&pdf, profile.toStdString());
    stream.getDict().replaceKey("/N", QPDFObjectHandle::newInteger(3));
    QPDFObjectHandle space = QPDFObjectHandle::newArray(
        {QPDFObjectHandle::newName("/ICCBased"), pdf.makeIndirectObject(stream)});
    for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(pdf).getAllPages()) {
        QPDFObjectHandle resources = page.getAttribute("/Resources", true);
        if (!resources.getKey("/ColorSpace").isDictionary()) {
            resources.replaceKey("/ColorSpace", QPDFObjectHandle::newDictionary());
        }
        resources.getKey("/ColorSpace").replaceKey("/DefaultRGB", space);
    }
}

// Writes the document piece by piece with `write`.
void writeBy(QPDF& pdf, const char* version,
             const std::function<void(const char* bytes, qint64 count)>& write) {
    Pl_Function output("document", nullptr, [&](const unsigned char* bytes, std::size_t count) {
        write(reinterpret_cast<const char*>(bytes), qint64(count));
    });
    QPDFWriter writer(pdf);
    writer.setOutputPipeline(&output);
    writer.setDeterministicID(true);
    writer.setStreamDataMode(qpdf_s_preserve);
    writer.setMinimumPDFVersion(version);
    writer.write();
}

constexpr char withPrintScaling[] = "1.6"; // the first version with PrintScaling

const char* versionFor(const PdfSettings& settings) {
    return isForOlderRip(settings) ? "1.4" : withPrintScaling; // older processors ignore the entry
}

QByteArray written(QPDF& pdf, const char* version) {
    QByteArray bytes;
    writeBy(pdf, version, [&](const char* more, qint64 count) { bytes.append(more, count); });
    return bytes;
}

// Adds RGB pages that Qt has drawn. `picture` replaces their images; null: the images stay.
void addDrawnPages(QPDF& pdf, const std::vector<PdfPage>& pages, const QByteArray& drawn,
                   const PackedPixels* picture) {
    pdf.processMemoryFile("drawn.pdf", drawn.constData(), std::size_t(drawn.size()));
    std::vector<QPDFPageObjectHelper> drawnPages = QPDFPageDocumentHelper(pdf).getAllPages();
    for (std::size_t i = 0; i < pages.size(); ++i) {
        setExactBox(drawnPages.at(i).getObjectHandle(), inPoints(pages[i].size));
    }
    if (picture) {
        const QPDFObjectHandle image =
            imageObject(pdf, *picture, QPDFObjectHandle::newName("/DeviceRGB"));
        for (QPDFPageObjectHelper& page : drawnPages) {
            QPDFObjectHandle objects = page.getAttribute("/Resources", false).getKey("/XObject");
            for (const auto& [name, drawnImage] : page.getImages()) {
                objects.replaceKey(name, image);
            }
        }
    }
}

// Adds the information that Qt writes into its documents.
void addInformation(QPDF& pdf, const QString& title) {
    const auto text = [](const QString& words) {
        return QPDFObjectHandle::newUnicodeString(words.toStdString());
    };
    QPDFObjectHandle info = QPDFObjectHandle::newDictionary();
    info.replaceKey("/Title", text(title));
    info.replaceKey("/Creator", text(QStringLiteral("Dipwright ") + programVersion()));
    info.replaceKey("/Producer", text(QStringLiteral("Dipwright")));
    pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(info));
}

// Makes the document and calls write(pdf) with it.
template <typename Write>
void makeDocument(const std::vector<PdfPage>& pages, const PdfSettings& settings,
                  const Write& write) {
    const QByteArray drawn =
        settings.inks ? QByteArray() : drawnPdf(pages, settings.title, settings.picture != nullptr);
    QPDF pdf; // reads from `drawn` on demand
    if (settings.inks) {
        pdf.emptyPDF();
        addInkedPages(pdf, pages, *settings.inks, settings.pdfTarget);
        addInformation(pdf, settings.title);
    } else {
        addDrawnPages(pdf, pages, drawn, settings.picture.get());
    }
    const bool inSrgb = settings.outputProfile.isEmpty();
    const QByteArray profile =
        inSrgb ? QColorSpace(QColorSpace::SRgb).iccProfile() : settings.outputProfile;
    if (inSrgb) {
        setRgbSpace(pdf, profile);
    }
    addOutputIntent(pdf, profile, settings);
    pdf.getRoot().replaceKey("/ViewerPreferences",
                             QPDFObjectHandle::parse("<< /PrintScaling /None >>"));
    QPDFObjectHandle info = pdf.getTrailer().getKey("/Info");
    info.removeKey("/CreationDate");
    info.removeKey("/ModDate");
    info.replaceKey("/Trapped", QPDFObjectHandle::newName("/False"));
    if (isOutputDevice(profile)) {
        declarePdfX(pdf, settings);
    }
    write(pdf);
}

} // namespace

bool replacesImages(const QPainter& painter) {
    return isInkedPage(painter) || drawsImagesLater(painter);
}

QByteArray pdfDocument(const std::vector<PdfPage>& pages, const PdfSettings& settings) {
    QByteArray bytes;
    makeDocument(pages, settings, [&](QPDF& pdf) { bytes = written(pdf, versionFor(settings)); });
    return bytes;
}

void writePdf(const std::vector<PdfPage>& pages, const PdfSettings& settings, QIODevice& device,
              const QString& message, const QString& where) {
    makeDocument(pages, settings, [&](QPDF& pdf) {
        writeBy(pdf, versionFor(settings), [&](const char* bytes, qint64 count) {
            if (device.write(bytes, count) != count) {
                throw Error(message.arg(device.errorString()), where);
            }
        });
    });
}

QByteArray repeatedPdf(const QByteArray& document, int copies) {
    QPDF pdf;
    try {
        pdf.processMemoryFile("document.pdf", document.constData(), std::size_t(document.size()));
    } catch (const std::exception& failure) {
        throw Error(QString::fromUtf8(failure.what()), QStringLiteral("PDF"));
    }
    QPDFPageDocumentHelper helper(pdf);
    const std::vector<QPDFPageObjectHelper> pages = helper.getAllPages();
    for (int copy = 1; copy < copies; ++copy) {
        for (const QPDFPageObjectHelper& page : pages) {
            helper.addPage(QPDFPageObjectHelper(page).shallowCopyPage(), false);
        }
    }
    return written(pdf, pdf.getPDFVersion().c_str());
}

} // namespace dipwright
