#include "workbench/dip/DipCacheUpdater.h"

#include "base/Error.h"
#include "base/PostToThread.h"
#include "pipeline/DipCache.h"

#include <QFileInfo>
#include <QPointer>
#include <chrono>

namespace dipwright {

namespace {

constexpr std::chrono::seconds keepAfter{10};

} // namespace

DipCacheUpdater::DipCacheUpdater(DipSession& session, JobRunner& jobs,
                                 const SolverRegistry& registry, Messages& messages,
                                 QObject* parent)
    : QObject(parent), session_(session), jobs_(jobs), registry_(registry), messages_(messages) {
    writer_.setMaxThreadCount(1);
    delay_.setSingleShot(true);
    delay_.setInterval(keepAfter);
    connect(&delay_, &QTimer::timeout, this, &DipCacheUpdater::keep);
    connect(&session, &DipSession::finished, this, &DipCacheUpdater::keepSoon);
}

DipCacheUpdater::~DipCacheUpdater() {
    keep();
    writer_.waitForDone();
}

void DipCacheUpdater::showDocument() {
    keep();
    if (const Document* document = session_.document()) {
        connect(document, &Document::fileChanged, this,
                &DipCacheUpdater::keepSoon); // the document may have a file now
        find();
    }
}

void DipCacheUpdater::find() {
    const Document& document = *session_.document();
    if (!wanted_ || document.path().isEmpty() ||
        !QFileInfo::exists(dipCacheFile(document.path()))) {
        return;
    }
    using Kept = std::shared_ptr<const JobResult>;
    jobs_.start(std::make_unique<ValueJob<Kept>>(
        tr("Reading cached results"),
        [project = document.project(), path = document.path(), &registry = registry_](
            const Progress& progress) { return cachedDips(project, registry, path, progress); },
        [this, document = QPointer(&document)](const Kept& kept) {
            if (kept && document && document == session_.document() && !document->result() &&
                document->project() == kept->project) {
                messages_.log(tr("Took the results from the cache file beside the project."));
                session_.setKept(kept);
                emit found();
            }
        },
        [this](const std::exception_ptr& failure) { reportOnce(sentenceOf(failure)); }));
}

void DipCacheUpdater::keepSoon() {
    const Document* document = session_.document();
    if (wanted_ && document && document->result() && !document->path().isEmpty()) {
        result_ = document->result();
        path_ = document->path();
        delay_.start();
    }
}

void DipCacheUpdater::keep() {
    delay_.stop();
    if (!result_) {
        return;
    }
    writer_.start([this, result = std::exchange(result_, nullptr), path = path_] {
        try {
            cacheDips(*result, path);
        } catch (const Error& error) {
            postToThread(*this, [this, sentence = error.sentence()] { reportOnce(sentence); });
        }
    });
}

// The user did not ask for the cache, so a failure shows one line, and only once.
void DipCacheUpdater::reportOnce(const QString& sentence) {
    if (!std::exchange(told_, true)) {
        messages_.logAndSay(sentence);
    }
}

} // namespace dipwright
