// Controls the page that measures a film: runs its requests as jobs and shows their results.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/inspection/FilmPage.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

class FilmWatchController : public QObject {
    Q_OBJECT

public:
    FilmWatchController(const DipSession& session, JobRunner& jobs, Messages& messages,
                        QWidget& window);

    FilmPage* page() const { return page_; } // its window owns it
    // Call this when the session has another document.
    void showDocument();

private:
    void showProject();
    double profileBegin() const; // s
    void addPhotos(const QStringList& files);
    void measure();
    void measureTrusted();
    void reportChangedPhotos(const FilmOnWater& film, const FilmWatch& watch);
    void askProfile();
    void save(const QString& profile);
    void savePages();
    void exportFilm();
    WatchNotes notes() const;

    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
    FilmPage* page_;
    std::shared_ptr<const WatchedFilm> measured_;
    FilmOnWater measuredFilm_; // the inputs of measured_
    double measuredBegin_ = 0; // start of the dip in measured_, seconds
};

} // namespace dipwright
