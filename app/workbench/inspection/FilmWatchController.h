// A film on the water measured by photos: what its page asks for, done by jobs, and told to it.
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

    FilmPage* page() const { return page_; } // belongs to who puts it into a window
    // To be called when the session has another document.
    void showDocument();

private:
    void showProject();
    double profileBegin() const; // s
    void addPhotos(const QStringList& files);
    void measure();
    void measureTrusted();
    void tellOthers(const FilmOnWater& film, const FilmWatch& watch);
    void askProfile();
    void save(const QString& profile);
    void exportFilm();
    WatchNotes notes() const;

    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
    FilmPage* page_;
    std::shared_ptr<const WatchedFilm> measured_;
    FilmOnWater measuredFilm_; // as it was then, …
    double measuredBegin_ = 0; // … and when the dip began
};

} // namespace dipwright
