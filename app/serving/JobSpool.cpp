#include "serving/JobSpool.h"

#include "base/Error.h"
#include "disk/AtomicFile.h"
#include "disk/SmallFile.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonDocument>
#include <QRandomGenerator>
#include <QStorageInfo>
#include <algorithm>
#include <array>
#include <new>

namespace dipwright {
namespace {

const QString records = QStringLiteral("records");
const QString results = QStringLiteral("results");
const QString incoming = QStringLiteral("incoming");
const QString suffix = QStringLiteral(".dipw");
constexpr std::array allStates{ServedState::Queued, ServedState::Running, ServedState::Done,
                               ServedState::Failed, ServedState::Cancelled};
constexpr int mostUploads = 4; // at the same time
constexpr qint64 mostRecordBytes = 1 << 20;
constexpr int longestName = 100;

QStringList folderNames() {
    QStringList names{records, results, incoming};
    for (const ServedState state : allStates) {
        names << nameOf(state);
    }
    return names;
}

bool isFinished(ServedState state) {
    return state != ServedState::Queued && state != ServedState::Running;
}

// Returns a name that sorts by time and that nobody can guess.
QString newId() {
    return QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmsszzz")) +
           QStringLiteral("-%1").arg(QRandomGenerator::system()->generate64(), 16, 16, QChar(u'0'));
}

QString plainName(QString name) {
    name = QFileInfo(name.simplified()).fileName();
    if (name.endsWith(suffix, Qt::CaseInsensitive)) {
        name.chop(suffix.size());
    }
    name.removeIf([](QChar c) { return !c.isPrint(); });
    return name.isEmpty() ? QStringLiteral("job") : name.left(longestName);
}

} // namespace

QString nameOf(ServedState state) {
    switch (state) {
    case ServedState::Queued:
        return QStringLiteral("queued");
    case ServedState::Running:
        return QStringLiteral("running");
    case ServedState::Done:
        return QStringLiteral("done");
    case ServedState::Failed:
        return QStringLiteral("failed");
    case ServedState::Cancelled:
        break;
    }
    return QStringLiteral("cancelled");
}

JobSpool::JobSpool(const QString& folder, const SpoolLimits& limits, RunServedJob run)
    : folders_(folder, folderNames(), QStringLiteral("serve")), limits_(limits),
      run_(std::move(run)) {
    QFile::setPermissions(folders_.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    for (const QFileInfo& file : QDir(folders_.folder(incoming)).entryInfoList(QDir::Files)) {
        QFile::remove(file.filePath()); // cut off when the program ended
    }
    readJobs();
    worker_ = std::thread([this] { work(); });
}

JobSpool::~JobSpool() {
    stop();
    worker_.join();
}

void JobSpool::stop() {
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
        current_.cancel();
    }
    wake_.notify_all();
}

QString JobSpool::projectOf(const ServedJob& job) const {
    return folders_.folder(nameOf(job.state)) + u'/' + job.id + suffix;
}

QString JobSpool::resultsOf(const QString& id) const {
    return folders_.folder(results) + u'/' + id;
}

void JobSpool::readJobs() {
    for (const ServedState state : allStates) {
        for (const QFileInfo& file :
             QDir(folders_.folder(nameOf(state))).entryInfoList({u'*' + suffix}, QDir::Files)) {
            ServedJob job;
            job.id = file.completeBaseName();
            job.state = state;
            QJsonObject record;
            try {
                record = QJsonDocument::fromJson(readSmallFile(folders_.folder(records) + u'/' +
                                                                   job.id + QStringLiteral(".json"),
                                                               mostRecordBytes))
                             .object();
            } catch (const Error&) { // the job runs without its name
            }
            job.name = plainName(record[QStringLiteral("name")].toString());
            job.submitted = QDateTime::fromString(record[QStringLiteral("submitted")].toString(),
                                                  Qt::ISODateWithMs);
            job.text = record[QStringLiteral("text")].toString();
            job.outcome = record[QStringLiteral("outcome")].toObject();
            job.progress = state == ServedState::Done ? 1 : 0;
            jobs_[job.id] = job;
        }
    }
    for (const auto& [id, job] : std::map(jobs_)) {
        if (job.state == ServedState::Running) {
            end(id, ServedState::Failed,
                QStringLiteral(
                    "The server ended unexpectedly while it ran this job. Send it again"),
                {});
        }
    }
}

std::optional<QString> JobSpool::newUpload() {
    const std::scoped_lock lock(mutex_);
    const bool hasRoom =
        QStorageInfo(folders_.path()).bytesAvailable() > 2 * limits_.mostBytes * (uploads_ + 1);
    if (int(jobs_.size()) + uploads_ >= limits_.mostJobs || uploads_ >= mostUploads || !hasRoom) {
        return std::nullopt;
    }
    ++uploads_;
    return folders_.folder(incoming) + u'/' + newId() + suffix;
}

void JobSpool::dropUpload(const QString& upload) {
    QFile::remove(upload);
    const std::scoped_lock lock(mutex_);
    --uploads_;
}

ServedJob JobSpool::add(const QString& upload, const QString& name) {
    ServedJob job;
    job.id = QFileInfo(upload).completeBaseName();
    job.name = plainName(name);
    job.submitted = QDateTime::currentDateTimeUtc();
    const std::scoped_lock lock(mutex_);
    record(job);
    folders_.move(upload, nameOf(job.state));
    --uploads_;
    jobs_[job.id] = job;
    wake_.notify_all();
    return job;
}

std::vector<ServedJob> JobSpool::jobs() const {
    const std::scoped_lock lock(mutex_);
    std::vector<ServedJob> list;
    for (const auto& [id, job] : jobs_) {
        list.push_back(job);
    }
    return list;
}

std::optional<ServedJob> JobSpool::job(const QString& id) const {
    const std::scoped_lock lock(mutex_);
    const auto found = jobs_.find(id);
    return found == jobs_.end() ? std::nullopt : std::optional(found->second);
}

bool JobSpool::cancel(const QString& id) {
    const std::scoped_lock lock(mutex_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end() || isFinished(found->second.state)) {
        return false;
    }
    if (running_ == id) {
        userCancelled_ = true;
        current_.cancel();
    } else {
        end(id, ServedState::Cancelled, QStringLiteral("Cancelled before it ran"), {});
    }
    return true;
}

bool JobSpool::remove(const QString& id) {
    const std::scoped_lock lock(mutex_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end()) {
        return false;
    }
    if (running_ == id) {
        userCancelled_ = userRemoved_ = true;
        current_.cancel();
    } else {
        erase(id);
    }
    return true;
}

// The lock is held.
void JobSpool::erase(const QString& id) {
    const QString project = projectOf(jobs_.at(id));
    QFile::remove(project);
    QFile::remove(project + QStringLiteral(".txt"));
    QFile::remove(folders_.folder(records) + u'/' + id + QStringLiteral(".json"));
    QDir(resultsOf(id)).removeRecursively();
    jobs_.erase(id);
}

QStringList JobSpool::files(const QString& id) const {
    const std::optional<ServedJob> known = job(id); // no other text becomes part of a path
    QStringList names;
    if (known && known->state == ServedState::Done) {
        const QDir folder(resultsOf(id));
        for (QDirIterator files(folder.path(), QDir::Files, QDirIterator::Subdirectories);
             files.hasNext();) {
            names << folder.relativeFilePath(files.next());
        }
        names.sort();
    }
    return names;
}

QString JobSpool::file(const QString& id, const QString& name) const {
    return files(id).contains(name) ? resultsOf(id) + u'/' + name : QString();
}

void JobSpool::work() {
    while (true) {
        QString next;
        {
            std::unique_lock lock(mutex_);
            const auto isQueued = [](const auto& entry) {
                return entry.second.state == ServedState::Queued;
            };
            wake_.wait(lock, [&] { return ending_ || std::ranges::any_of(jobs_, isQueued); });
            if (ending_) {
                return;
            }
            next = std::ranges::find_if(jobs_, isQueued)->first;
        }
        run(next);
    }
}

// Returns false if the job is not to be run, or cannot be.
bool JobSpool::begin(const QString& id, const CancelToken& cancelToken) {
    const std::scoped_lock lock(mutex_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end() || found->second.state != ServedState::Queued || ending_) {
        return false;
    }
    try {
        folders_.move(projectOf(found->second), nameOf(ServedState::Running));
    } catch (const Error& error) {
        end(id, ServedState::Failed, error.sentence(), {});
        return false;
    }
    found->second.state = ServedState::Running;
    running_ = id;
    current_ = cancelToken;
    userCancelled_ = userRemoved_ = false;
    return true;
}

void JobSpool::run(const QString& id) {
    CancelToken cancelToken;
    if (!begin(id, cancelToken)) {
        return;
    }
    ServedState state = ServedState::Done;
    QString text;
    QJsonObject outcome;
    try {
        outcome = runWithinTime(id, cancelToken);
    } catch (const Cancelled&) {
        state = ServedState::Cancelled;
        text = QStringLiteral("Cancelled");
    } catch (const Error& error) {
        state = ServedState::Failed;
        text = error.sentence();
    } catch (const std::bad_alloc&) {
        state = ServedState::Failed;
        text = QStringLiteral("There is not enough memory for this job");
    } catch (const std::exception& failure) {
        state = ServedState::Failed;
        text = QString::fromLocal8Bit(failure.what());
    }
    const std::scoped_lock lock(mutex_);
    running_.clear();
    if (state == ServedState::Cancelled && ending_ && !userCancelled_) {
        state = ServedState::Queued;
        text.clear();
    }
    end(id, state, text, outcome);
    if (userRemoved_) {
        erase(id);
    }
}

QJsonObject JobSpool::runWithinTime(const QString& id, const CancelToken& cancelToken) {
    QElapsedTimer time;
    time.start();
    bool isTooLong = false; // only this thread reports progress of a whole job
    Progress progress;
    progress.cancelToken = cancelToken;
    progress.report = [&](double share, const QString& text) {
        const std::scoped_lock lock(mutex_);
        jobs_[id].progress = share;
        jobs_[id].text = text;
        if (time.elapsed() > qint64(limits_.mostSeconds) * 1000) {
            isTooLong = true;
            current_.cancel();
        }
    };
    QString project;
    {
        const std::scoped_lock lock(mutex_);
        project = projectOf(jobs_[id]);
    }
    try {
        return run_(project, resultsOf(id), progress);
    } catch (const Cancelled&) {
        if (isTooLong) {
            throw Error(QStringLiteral("The job took longer than the server allows: %1 s")
                            .arg(limits_.mostSeconds),
                        {});
        }
        throw;
    }
}

// The lock is held, or there are no other threads yet.
void JobSpool::end(const QString& id, ServedState state, const QString& text,
                   const QJsonObject& outcome) {
    ServedJob& job = jobs_[id];
    const QString project = projectOf(job);
    job.state = state;
    job.text = text;
    job.outcome = outcome;
    job.progress = state == ServedState::Done ? 1 : 0;
    const auto fail = [&job](const Error& error) { // the disk is full or gone: clients get to know
        job.state = ServedState::Failed;
        job.text = error.sentence();
    };
    try {
        if (isFinished(state)) {
            folders_.end(project, nameOf(state), text);
        } else {
            folders_.move(project, nameOf(state));
        }
    } catch (const Error& error) {
        fail(error);
    }
    try {
        record(job);
    } catch (const Error& error) {
        fail(error);
    }
}

void JobSpool::record(const ServedJob& job) const {
    const QJsonObject json{{"name", job.name},
                           {"submitted", job.submitted.toString(Qt::ISODateWithMs)},
                           {"text", job.text},
                           {"outcome", job.outcome}};
    writeAtomically(folders_.folder(records) + u'/' + job.id + QStringLiteral(".json"),
                    [&](QIODevice& device) { device.write(QJsonDocument(json).toJson()); });
}

} // namespace dipwright
