#include "workbench/view/CradleView.h"

#include "pipeline/JobCradles.h"
#include "workbench/jobs/StartJob.h"

#include <QAction>

namespace dipwright {

CradleView::CradleView(QAction& action, DipScene& scene, const DipSession& session, JobRunner& jobs,
                       Messages& messages, QObject* parent)
    : QObject(parent), action_(action), scene_(scene), session_(session), jobs_(jobs),
      messages_(messages) {
    connect(&action, &QAction::toggled, this, [this](bool on) {
        if (on) {
            make();
        } else {
            isShown_ = false;
            scene_.setCradles(nullptr);
        }
    });
    for (const auto changed : {&DipSession::finished, &DipSession::dropped}) {
        connect(&session, changed, &action, [this] { action_.setChecked(false); });
    }
    connect(&jobs, &JobRunner::idle, this, [this] { // it failed or was cancelled
        action_.setChecked(action_.isChecked() && isShown_);
    });
}

void CradleView::make() {
    const auto result = session_.outcome().result;
    if (!result) {
        action_.setChecked(false);
        return;
    }
    startJob(
        jobs_, messages_, tr("Making the cradle"), tr("Show cradle"),
        [result](const Progress& progress) {
            return Cradles(std::make_shared<const std::vector<Cradle>>(
                result->cradles.empty() ? jobCradles(*result, progress) : result->cradles));
        },
        [this, result](const Cradles& cradles) {
            if (result == session_.outcome().result && action_.isChecked()) {
                show(cradles);
            }
        });
}

void CradleView::show(const Cradles& cradles) {
    isShown_ = true;
    scene_.setCradles(cradles);
    QStringList notes;
    for (const Cradle& cradle : *cradles) {
        notes.append(cradle.notes);
    }
    if (!notes.isEmpty()) {
        messages_.notice(notes.join(QLatin1Char('\n')));
    }
}

} // namespace dipwright
