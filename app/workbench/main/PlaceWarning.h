// Warns in the status line when the body's place does not allow a good dip.
#pragma once

#include "workbench/dip/DipSession.h"

namespace dipwright {

class StatusLine;

class PlaceWarning : public QObject {
    Q_OBJECT

public:
    PlaceWarning(const DipSession& session, StatusLine& status);

    // Call this when the session has another document.
    void showDocument();

private:
    void show();

    const DipSession& session_;
    StatusLine& status_;
};

} // namespace dipwright
