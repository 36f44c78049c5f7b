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
    : QObject(parent), document_(document),
      copy_(folder + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces) +
            QStringLiteral(".dipw")) {
    writer_.setMaxThreadCount(1);
    timer_.setSingleShot(true);
    setInterval(defaultIntervalSeconds);
    connect(&timer_, &QTimer::timeout, this, &AutoSaver::keepNow);
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
    waitForCopy();
}

void AutoSaver::setInterval(int seconds) {
    timer_.setInterval(seconds * 1000);
}

void AutoSaver::scheduleCopy() {
    if (!timer_.isActive()) {
        timer_.start();
    }
}

bool AutoSaver::waitForCopy() {
    writer_.waitForDone();
    return isKept_;
}

void AutoSaver::continueCopy(const RecoveredDocument& restored) {
    timer_.stop();
    copy_ = restored.copy;
    lockCopy();
}

void AutoSaver::lockCopy() {
    if (!lock_.isHeld()) {
        lock_.acquire(copy_);
    }
}

void AutoSaver::keepNow() {
    timer_.stop();
    const QJsonObject description{
        {QStringLiteral("original"), document_.path()},
        {QStringLiteral("name"), document_.title()},
        {QStringLiteral("version"), document_.version().text()},
    };
    writing_ = {};
    writer_.start([this, project = document_.project(), bytes = QJsonDocument(description).toJson(),
                   cancelToken = writing_] { writeCopy(project, bytes, cancelToken); });
}

void AutoSaver::writeCopy(const Project& project, const QByteArray& description,
                          const CancelToken& cancelToken) {
    try {
        QDir().mkpath(QFileInfo(copy_).path());
        lockCopy();
        writeAtomically(besides(copy_, ".json"),
                        [&](QIODevice& device) { device.write(description); });
        saveProject(project, copy_, {}, {nullptr, cancelToken});
        isKept_ = true;
    } catch (const Cancelled&) {
        return; // the copy is about to be removed
    } catch (const Error& error) {
        if (isKept_.exchange(false)) {
            emit failed(error.sentence());
        }
    }
}

void AutoSaver::discard() {
    timer_.stop();
    writing_.cancel();
    writer_.start([this] {
        QFile::remove(copy_);
        QFile::remove(besides(copy_, ".json"));
        lock_.release();
    });
}

} // namespace dipwright
