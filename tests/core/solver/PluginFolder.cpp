#include "PluginFolder.h"

#include <dipwright/FilmSolver.h>

#include <QFile>
#include <QJsonDocument>
#include <stdexcept>

namespace dipwright::test {

QString PluginFolder::moduleName(const QString& id) {
#if defined(Q_OS_WIN)
    return id + QStringLiteral(".dll");
#else
    return id + QStringLiteral(".so"); // CMake's suffix for modules, on macOS too
#endif
}

QJsonObject PluginFolder::description(const QString& id) {
    return {{QStringLiteral("format"), QStringLiteral("dipwright-solver")},
            {QStringLiteral("interface"), solver::interfaceVersion},
            {QStringLiteral("id"), id},
            {QStringLiteral("name"), QStringLiteral("The solver %1").arg(id)},
            {QStringLiteral("version"), QStringLiteral("1.2.3")},
            {QStringLiteral("device"), QStringLiteral("cpu")},
            {QStringLiteral("vendor"), QStringLiteral("A test")},
            {QStringLiteral("module"), moduleName(id)},
            {QStringLiteral("priority"), 1}};
}

void PluginFolder::write(const QString& name, const QByteArray& content) const {
    QFile file(filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
        throw std::runtime_error("cannot write " + file.fileName().toStdString());
    }
}

void PluginFolder::describe(const QJsonObject& description, const QString& fileName) const {
    const QString name = fileName.isEmpty()
                             ? description[QLatin1String("id")].toString() + QStringLiteral(".json")
                             : fileName;
    write(name, QJsonDocument(description).toJson());
}

void PluginFolder::add(const QString& id, const QString& module) const {
    describe(description(id));
    QFile::remove(filePath(moduleName(id)));
    if (!QFile::copy(module, filePath(moduleName(id)))) {
        throw std::runtime_error("cannot copy " + module.toStdString());
    }
}

} // namespace dipwright::test
