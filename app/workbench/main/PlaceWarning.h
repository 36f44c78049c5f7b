// Says at the bottom of a window when the body lies where it cannot be dipped well.
#pragma once

#include "workbench/dip/DipSession.h"

namespace dipwright {

class StatusLine;

class PlaceWarning : public QObject {
    Q_OBJECT

public:
    PlaceWarning(const DipSession& session, StatusLine& status);

    // To be called when the session has another document.
    void showDocument();

private:
    void show();

    const DipSession& session_;
    StatusLine& status_;
};

} // namespace dipwright
