// Opens the tank-side page, and stores its times with the jobs: in the open document, or in the
// file of a project that no window has open.
#pragma once

#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"
#include "workbench/tank/TankPage.h"

#include <QPointer>

namespace dipwright {

class TankController : public QObject {
    Q_OBJECT

public:
    // Returns the open document of a project file, or null.
    using OpenDocument = std::function<Document*(const QString& path)>;

    explicit TankController(OpenDocument openDocument, QObject* parent = nullptr);
    ~TankController() override;

    // Opens the page for at least one job. `shown` is the document of a job without a file; it may
    // be null. An earlier page is closed; its progress is kept.
    void open(std::vector<TankJob> jobs, Document* shown);

private:
    void keep(const TankJob& job, const std::vector<TankTime>& times);
    void keepInFile(const TankJob& job, const std::vector<TankTime>& times);
    void say(const QString& sentence);

    OpenDocument openDocument_;
    QPointer<Document> shown_;
    QPointer<TankPage> page_;
    Messages messages_;
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
