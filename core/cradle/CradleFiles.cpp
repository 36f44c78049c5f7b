#include "cradle/CradleFiles.h"

#include "disk/ZipWriter.h"

#include <QDataStream>
#include <QIODevice>
#include <QXmlStreamWriter>

namespace dipwright {
namespace {

constexpr qsizetype stlHeader = 80;
const QString coreNamespace =
    QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/core/2015/02");

// The type of each kind of file in the package.
constexpr char contentTypes[] =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
// Names the file in the package that is the model.
constexpr char relationships[] =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

void writeMesh(QXmlStreamWriter& xml, const TriangleMesh& mesh) {
    xml.writeStartElement(QStringLiteral("mesh"));
    xml.writeStartElement(QStringLiteral("vertices"));
    const auto plain = [](float number) { return QString::number(number, 'f', 4); };
    for (const Eigen::Vector3f& place : mesh.positions) {
        xml.writeEmptyElement(QStringLiteral("vertex"));
        xml.writeAttribute(QStringLiteral("x"), plain(place.x()));
        xml.writeAttribute(QStringLiteral("y"), plain(place.y()));
        xml.writeAttribute(QStringLiteral("z"), plain(place.z()));
    }
    xml.writeEndElement();
    xml.writeStartElement(QStringLiteral("triangles"));
    for (const auto& [a, b, c] : mesh.triangles) {
        xml.writeEmptyElement(QStringLiteral("triangle"));
        xml.writeAttribute(QStringLiteral("v1"), QString::number(a));
        xml.writeAttribute(QStringLiteral("v2"), QString::number(b));
        xml.writeAttribute(QStringLiteral("v3"), QString::number(c));
    }
    xml.writeEndElement();
    xml.writeEndElement();
}

QByteArray modelXml(const TriangleMesh& mesh, const QString& title) {
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.writeStartDocument();
    xml.writeStartElement(QStringLiteral("model"));
    xml.writeAttribute(QStringLiteral("unit"), QStringLiteral("millimeter"));
    xml.writeDefaultNamespace(coreNamespace);
    xml.writeStartElement(QStringLiteral("metadata"));
    xml.writeAttribute(QStringLiteral("name"), QStringLiteral("Title"));
    xml.writeCharacters(title);
    xml.writeEndElement();
    xml.writeStartElement(QStringLiteral("resources"));
    xml.writeStartElement(QStringLiteral("object"));
    xml.writeAttribute(QStringLiteral("id"), QStringLiteral("1"));
    xml.writeAttribute(QStringLiteral("type"), QStringLiteral("model"));
    xml.writeAttribute(QStringLiteral("name"), title);
    writeMesh(xml, mesh);
    xml.writeEndElement();
    xml.writeEndElement();
    xml.writeStartElement(QStringLiteral("build"));
    xml.writeEmptyElement(QStringLiteral("item"));
    xml.writeAttribute(QStringLiteral("objectid"), QStringLiteral("1"));
    xml.writeEndDocument();
    return bytes;
}

} // namespace

QByteArray cradleStl(const Cradle& cradle) {
    const TriangleMesh mesh = transformed(cradle.mesh, cradle.poseToPrinter);
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.setFloatingPointPrecision(QDataStream::SinglePrecision);
    QByteArray header("Dipwright cradle, mm");
    header = header.leftJustified(stlHeader);
    stream.writeRawData(header.constData(), int(header.size()));
    stream << quint32(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Eigen::Vector3f normal = triangleNormal(mesh, t);
        stream << normal.x() << normal.y() << normal.z();
        for (const std::uint32_t corner : mesh.triangles[t]) {
            const Eigen::Vector3f& place = mesh.positions[corner];
            stream << place.x() << place.y() << place.z();
        }
        stream << quint16(0);
    }
    return bytes;
}

QByteArray cradle3mf(const Cradle& cradle, const QString& title) {
    const TriangleMesh mesh = transformed(cradle.mesh, cradle.poseToPrinter);
    ZipWriter archive;
    const auto add = [&](const char* name, const QByteArray& contents) {
        archive.add(QLatin1String(name), contents, ZipWriter::Packing::Deflated);
    };
    add("[Content_Types].xml", contentTypes);
    add("_rels/.rels", relationships);
    add("3D/3dmodel.model", modelXml(mesh, title));
    return archive.finish();
}

} // namespace dipwright
