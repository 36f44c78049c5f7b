#include "sheet/pdf/PdfX.h"

#include "base/ProgramName.h"
#include "base/Sha256.h"

#include <QDate>
#include <QRegularExpression>
#include <QUuid>
#include <QXmlStreamWriter>

namespace dipwright {
namespace {

// PDF/X-1a allows only profiles up to version 2 (ICC.1, 7.2.4), as PDF 1.4 knows them.
const char* versionFor(const PdfSettings& settings) {
    return isForOlderRip(settings) && settings.outputProfile.at(8) <= 2 ? "PDF/X-1a:2003"
                                                                        : "PDF/X-4";
}

// XMP namespaces (ISO 16684-1) and their prefixes.
struct Vocabulary {
    const char* prefix;
    const char* address;
};
constexpr Vocabulary rdf{"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"};
constexpr Vocabulary titles{"dc", "http://purl.org/dc/elements/1.1/"};
constexpr Vocabulary basic{"xmp", "http://ns.adobe.com/xap/1.0/"};
constexpr Vocabulary media{"xmpMM", "http://ns.adobe.com/xap/1.0/mm/"};
constexpr Vocabulary document{"pdf", "http://ns.adobe.com/pdf/1.3/"};
constexpr Vocabulary standard{"pdfxid", "http://www.npes.org/pdfx/ns/id/"};

// Returns an identifier made from the streams' content, the same for the same pages.
QString documentId(QPDF& pdf) {
    Sha256 hash;
    for (QPDFObjectHandle& object : pdf.getAllObjects()) {
        if (object.isStream()) {
            const std::shared_ptr<Buffer> bytes = object.getRawStreamData();
            hash.add(QByteArrayView(bytes->getBuffer(), qsizetype(bytes->getSize())));
        }
    }
    const QUuid id = QUuid::createUuidV5(QUuid(), hash.result());
    return QStringLiteral("uuid:") + id.toString(QUuid::WithoutBraces);
}

// Returns the time that PDF/X requires. It does not come from the clock, so that the same sheet
// gives the same file. If the project has no date, it is 1970-01-01, which is clearly not a real
// date.
QString moment(const QString& date) {
    const QDate day = QDate::fromString(date, Qt::ISODate);
    return (day.isValid() ? day : QDate(1970, 1, 1)).toString(Qt::ISODate) +
           QStringLiteral("T00:00:00Z");
}

class XmpWriter {
public:
    XmpWriter() : xml_(&bytes_) {
        xml_.writeProcessingInstruction(
            QStringLiteral("xpacket"),
            QStringLiteral("begin=\"\ufeff\" id=\"W5M0MpCehiHzreSzNTczkc9d\""));
        for (const Vocabulary& one : {rdf, titles, basic, media, document, standard}) {
            xml_.writeNamespace(QLatin1String(one.address), QLatin1String(one.prefix));
        }
        start(rdf, "RDF");
        start(rdf, "Description");
        xml_.writeAttribute(QLatin1String(rdf.address), QStringLiteral("about"), QString());
    }

    void write(const Vocabulary& of, const char* name, const QString& value) {
        xml_.writeTextElement(QLatin1String(of.address), QLatin1String(name), value);
    }
    void writeTitle(const QString& title) {
        start(titles, "title");
        start(rdf, "Alt");
        start(rdf, "li");
        xml_.writeAttribute(QStringLiteral("xml:lang"), QStringLiteral("x-default"));
        xml_.writeCharacters(title);
        for (int level = 0; level < 3; ++level) {
            xml_.writeEndElement();
        }
    }
    QByteArray finish() {
        xml_.writeEndElement();
        xml_.writeEndElement();
        xml_.writeProcessingInstruction(QStringLiteral("xpacket"), QStringLiteral("end=\"r\""));
        return bytes_;
    }

private:
    void start(const Vocabulary& of, const char* name) {
        xml_.writeStartElement(QLatin1String(of.address), QLatin1String(name));
    }

    QByteArray bytes_;
    QXmlStreamWriter xml_;
};

} // namespace

bool isOutputDevice(const QByteArray& profile) {
    return profile.mid(12, 4) == "prtr"; // ICC.1, 7.2.5
}

bool isForOlderRip(const PdfSettings& settings) {
    return settings.inks && settings.pdfTarget == PdfTarget::OlderRip;
}

void declarePdfX(QPDF& pdf, const PdfSettings& settings) {
    const char* const version = versionFor(settings);
    QPDFObjectHandle info = pdf.getTrailer().getKey("/Info");
    const QString title = settings.title.isEmpty() ? QStringLiteral("Dipwright") : settings.title;
    const auto text = [](const QString& words) {
        return QPDFObjectHandle::newUnicodeString(words.toStdString());
    };
    info.replaceKey("/Title", text(title));
    info.replaceKey("/GTS_PDFXVersion", QPDFObjectHandle::newString(version));
    if (isForOlderRip(settings)) { // PDF/X-1a requires them
        const std::string time =
            "D:" + moment(settings.date).remove(QRegularExpression("[-:T]")).toStdString();
        info.replaceKey("/CreationDate", QPDFObjectHandle::newString(time));
        info.replaceKey("/ModDate", QPDFObjectHandle::newString(time));
    }

    XmpWriter xmp;
    xmp.write(standard, "GTS_PDFXVersion", QLatin1String(version));
    xmp.write(document, "Trapped", QStringLiteral("False"));
    xmp.write(document, "Producer",
              QString::fromStdString(info.getKey("/Producer").getUTF8Value()));
    xmp.write(basic, "CreatorTool", QString::fromStdString(info.getKey("/Creator").getUTF8Value()));
    for (const char* name : {"CreateDate", "ModifyDate", "MetadataDate"}) {
        xmp.write(basic, name, moment(settings.date));
    }
    xmp.write(media, "DocumentID", documentId(pdf));
    xmp.write(media, "VersionID", QStringLiteral("1"));
    xmp.write(media, "RenditionClass", QStringLiteral("default"));
    xmp.writeTitle(title);
    QPDFObjectHandle metadata = QPDFObjectHandle::newStream(&pdf, xmp.finish().toStdString());
    metadata.getDict().replaceKey("/Type", QPDFObjectHandle::newName("/Metadata"));
    metadata.getDict().replaceKey("/Subtype", QPDFObjectHandle::newName("/XML"));
    pdf.getRoot().replaceKey("/Metadata", metadata);
}

} // namespace dipwright
