#include "ObjFile.h"

#include "base/Error.h"

#include <QSaveFile>
#include <map>

namespace dipwright::samples {

namespace {

void writeFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        throw Error(QStringLiteral("The file cannot be written: %1").arg(file.errorString()), path);
    }
}

QByteArray objText(const TexturedMesh& model, const QString& name) {
    QByteArray positions;
    for (const Eigen::Vector3f& place : model.mesh.positions) {
        positions += QByteArray("v");
        for (const float value : place) {
            positions += ' ' + QByteArray::number(value, 'f', 4);
        }
        positions += '\n';
    }
    QByteArray coordinates;
    QByteArray faces;
    std::map<QByteArray, std::size_t> numbers; // shared coordinates are written once
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        faces += QByteArray("f");
        for (int corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2f& uv = model.textureCoordinates[t][corner];
            const QByteArray line = "vt " + QByteArray::number(uv.x(), 'f', 6) + ' ' +
                                    QByteArray::number(uv.y(), 'f', 6) + '\n';
            const auto [entry, isNew] = numbers.try_emplace(line, numbers.size() + 1);
            if (isNew) {
                coordinates += line;
            }
            faces += ' ' + QByteArray::number(model.mesh.triangles[t][corner] + 1) + '/' +
                     QByteArray::number(qulonglong(entry->second));
        }
        faces += '\n';
    }
    return "mtllib " + name.toUtf8() + ".mtl\n" + positions + coordinates + "usemtl paint\n" +
           faces;
}

} // namespace

void writeObj(const TexturedMesh& model, const QString& folder, const QString& name) {
    const QString base = folder + QLatin1Char('/') + name;
    writeFile(base + QStringLiteral(".obj"), objText(model, name));
    writeFile(base + QStringLiteral(".mtl"),
              "newmtl paint\nKd 1 1 1\nmap_Kd " + name.toUtf8() + ".png\n");
    const QString picture = base + QStringLiteral(".png");
    if (!model.textures.front().save(picture)) {
        throw Error(QStringLiteral("The picture cannot be written"), picture);
    }
}

} // namespace dipwright::samples
