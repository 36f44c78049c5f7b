#include "workbench/document/Recovery.h"

#include "base/Error.h"
#include "disk/AtomicFile.h"
#include "disk/PlainFile.h"
#include "project/ProjectStore.h"
#include "workbench/document/Document.h"

#include <QDateTime>
#include <QDir>
#include <QJsonDocument>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

namespace dipwright {

namespace {

constexpr int defaultIntervalSeconds = 20;
constexpr qint64 longestDescription = 1 << 20; // bytes

QString besides(const QString& copy, const char* extension) {
    return copy.left(copy.lastIndexOf(QLatin1Char('.'))) + QLatin1String(extension);
}

// Removes descriptions without a copy. Their program was killed before it wrote the copy.
void removeOrphanDescriptions(const QDir& folder) {
    for (const QString& description : folder.entryList({QStringLiteral("*.json")}, QDir::Files)) {
        const QString copy = besides(folder.filePath(description), ".dipw");
        FileLock lock;
        if (!QFileInfo::exists(copy) && lock.acquire(copy).acquired) {
            QFile::remove(folder.filePath(description));
        }
    }
}

} // namespace

QString recoveryFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/recovery");
}

std::vector<RecoveredDocument> findRecoveredDocuments(const QString& folder) {
    std::vector<RecoveredDocument> found;
    const QDir directory(folder);
    removeOrphanDescriptions(directory);
    for (const QFileInfo& copy :
         directory.entryInfoList({QStringLiteral("*.dipw")}, QDir::Files, QDir::Time)) {
        FileLock lock;
        if (!lock.acquire(copy.filePath()).acquired) {
            continue; // open in a running program
        }
        QFile description(besides(copy.filePath(), ".json"));
        QJsonObject json;
        if (openToRead(description).isEmpty()) {
            json = QJsonDocument::fromJson(description.read(longestDescription)).object();
        }
        found.push_back({copy.filePath(), json[QLatin1String("original")].toString(),
                         json[QLatin1String("name")].toString(copy.completeBaseName()),
                         copy.lastModified()});
        if (json.contains(QLatin1String("version"))) {
            found.back().version = FileVersion::fromText(json[QLatin1String("version")].toString());
        }
    }
    return found;
}

void discardRecovered(const RecoveredDocument& recovered) {
    for (const char* extension : {".dipw", ".json"}) {
        QFile::remove(besides(recovered.copy, extension));
    }
}

AutoSaver::AutoSaver(Document& document, const QString& folder, QObject* parent)
    : QObject(parent), document_(document), folder_(folder),
      name_(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
    writer_.setMaxThreadCount(1);
    timer_.setSingleShot(true);
    setInterval(defaultIntervalSeconds);
    connect(&timer_, &QTimer::timeout, this, &AutoSaver::write);
    connect(&document, &Document::projectChanged, this, &AutoSaver::scheduleCopy);
    connect(&document, &Document::fileChanged, this, [this] {
        if (document_.isModified()) {
            scheduleCopy();
        } else {
            discard();
        }
    });
    if (document.isModified()) {
        scheduleCopy();
    }
}

AutoSaver::~AutoSaver() {
    writer_.waitForDone();
}

void AutoSaver::setInterval(int seconds) {
    timer_.setInterval(seconds * 1000);
}

void AutoSaver::scheduleCopy() {
    if (!timer_.isActive()) {
        timer_.start();
    }
}

QString AutoSaver::file(const char* extension) const {
    return folder_ + QLatin1Char('/') + name_ + QLatin1String(extension);
}

bool AutoSaver::keepNow() {
    timer_.stop();
    write();
    writer_.waitForDone();
    return isKept_;
}

void AutoSaver::write() {
    QDir().mkpath(folder_);
    if (!lock_) {
        lock_ = std::make_unique<FileLock>();
        lock_->acquire(file(".dipw"));
    }
    const QJsonObject description{
        {QStringLiteral("original"), document_.path()},
        {QStringLiteral("name"), document_.title()},
        {QStringLiteral("version"), document_.version().text()},
    };
    writer_.start([this, project = document_.project(), description, copy = file(".dipw"),
                   about = file(".json")] {
        try {
            writeAtomically(about, [&](QIODevice& device) {
                device.write(QJsonDocument(description).toJson());
            });
            saveProject(project, copy);
            isKept_ = true;
        } catch (const Error& error) {
            if (isKept_.exchange(false)) {
                emit failed(error.sentence());
            }
        }
    });
}

void AutoSaver::discard() {
    timer_.stop();
    writer_.waitForDone();
    QFile::remove(file(".dipw"));
    QFile::remove(file(".json"));
    lock_.reset();
}

} // namespace dipwright
