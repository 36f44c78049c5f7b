// A temporary folder of solver plugins for tests.
#pragma once

#include <QJsonObject>
#include <QString>
#include <QTemporaryDir>

namespace dipwright::test {

class PluginFolder {
public:
    QString path() const { return folder_.path(); }
    QString filePath(const QString& name) const { return folder_.filePath(name); }

    // Returns a valid description of the plugin `id`, whose module is moduleName(id).
    static QJsonObject description(const QString& id);
    static QString moduleName(const QString& id);

    void write(const QString& name, const QByteArray& content) const;
    void describe(const QJsonObject& description, const QString& fileName = {}) const;
    // Writes the description of the plugin `id`, and copies `module` as its module.
    void add(const QString& id, const QString& module) const;

private:
    QTemporaryDir folder_;
};

} // namespace dipwright::test
