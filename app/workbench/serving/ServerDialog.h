// Asks for the job server that runs a project.
#pragma once

#include "workbench/serving/RemoteDips.h"

#include <QDialog>

class QLineEdit;

namespace dipwright {

class NoticeBar;

class ServerDialog : public QDialog {
    Q_OBJECT

public:
    explicit ServerDialog(QWidget* parent = nullptr);

    void accept() override; // stays open if an entry cannot be used

signals:
    void sent(const dipwright::ServerAccess& server);

private:
    NoticeBar* notice_;
    QLineEdit *address_, *token_;
};

} // namespace dipwright
