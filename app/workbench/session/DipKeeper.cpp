#include "session/DipKeeper.h"

#include "base/Error.h"
#include "base/HandOver.h"
#include "pipeline/KeptDips.h"

#include <QFileInfo>
#include <QPointer>
#include <chrono>

namespace dipwright {

namespace {

constexpr std::chrono::seconds keepAfter{10};

} // namespace

DipKeeper::DipKeeper(DipSession& session, JobRunner& jobs, const SolverRegistry& registry,
                     Messages& messages, QObject* parent)
    : QObject(parent), session_(session), jobs_(jobs), registry_(registry), messages_(messages) {
    writer_.setMaxThreadCount(1);
    delay_.setSingleShot(true);
    delay_.setInterval(keepAfter);
    connect(&delay_, &QTimer::timeout, this, &DipKeeper::keep);
    connect(&session, &DipSession::finished, this, &DipKeeper::keepSoon);
}

DipKeeper::~DipKeeper() {
    keep();
    writer_.waitForDone();
}

void DipKeeper::showDocument() {
    keep();
    if (const Document* document = session_.document()) {
        connect(document, &Document::fileChanged, this, &DipKeeper::keepSoon); // it has one now
        find();
    }
}

void DipKeeper::find() {
    const Document& document = *session_.document();
    if (!wanted_ || document.path().isEmpty() ||
        !QFileInfo::exists(keptDipsFile(document.path()))) {
        return;
    }
    using Kept = std::shared_ptr<const JobResult>;
    jobs_.start(std::make_unique<ValueJob<Kept>>(
        tr("Looking for results"),
        [project = document.project(), path = document.path(), &registry = registry_](
            const Progress& progress) { return keptDips(project, registry, path, progress); },
        [this, document = QPointer(&document)](const Kept& kept) {
            if (kept && document && document == session_.document() && !document->result() &&
                document->project() == kept->project) {
                messages_.log(tr("The results are those of the dips kept beside the project."));
                session_.setKept(kept);
                emit found();
            }
        },
        [this](const std::exception_ptr& failure) { tellOnce(sentenceOf(failure)); }));
}

void DipKeeper::keepSoon() {
    const Document* document = session_.document();
    if (wanted_ && document && document->result() && !document->path().isEmpty()) {
        result_ = document->result();
        path_ = document->path();
        delay_.start();
    }
}

void DipKeeper::keep() {
    delay_.stop();
    if (!result_) {
        return;
    }
    writer_.start([this, result = std::exchange(result_, nullptr), path = path_] {
        try {
            keepDips(*result, path);
        } catch (const Error& error) {
            handOver(*this, [this, sentence = error.sentence()] { tellOnce(sentence); });
        }
    });
}

// Nobody asked for it: a line, and not one for each run.
void DipKeeper::tellOnce(const QString& sentence) {
    if (!std::exchange(told_, true)) {
        messages_.logAndSay(sentence);
    }
}

} // namespace dipwright
