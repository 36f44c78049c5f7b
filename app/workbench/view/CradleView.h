// Shows in the view the cradle that would be written for the dip on show. Making it is a job.
#pragma once

#include "cradle/Cradle.h"
#include "workbench/dip/DipSession.h"
#include "workbench/jobs/Messages.h"
#include "workbench/view/DipScene.h"

class QAction;

namespace dipwright {

class CradleView : public QObject {
    Q_OBJECT

public:
    // `action` is checked while a cradle is shown or made. It is unchecked when there is another
    // result, because the cradle then no longer fits.
    CradleView(QAction& action, DipScene& scene, const DipSession& session, JobRunner& jobs,
               Messages& messages, QObject* parent = nullptr);

private:
    using Cradles = std::shared_ptr<const std::vector<Cradle>>;
    void make();
    void show(const Cradles& cradles);

    QAction& action_;
    DipScene& scene_;
    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    bool isShown_ = false;
};

} // namespace dipwright
