// A folder of plugins made up by a test.
#pragma once

#include <QJsonObject>
#include <QString>
#include <QTemporaryDir>

namespace dipwright::test {

class PluginFolder {
public:
    QString path() const { return folder_.path(); }
    QString filePath(const QString& name) const { return folder_.filePath(name); }

    // A description that is right in every way, of the module `id` + the system's module suffix.
    static QJsonObject description(const QString& id);
    static QString moduleName(const QString& id);

    void write(const QString& name, const QByteArray& content) const;
    void describe(const QJsonObject& description, const QString& fileName = {}) const;
    // Describes the plugin `id` and copies `module` as its module.
    void add(const QString& id, const QString& module) const;

private:
    QTemporaryDir folder_;
};

} // namespace dipwright::test
