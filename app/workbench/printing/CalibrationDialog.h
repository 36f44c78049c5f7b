// Calibrates a printer's scale. The user prints and measures a page of rulers, stores the scale in
// the printer's profile, and verifies it with a second page.
#pragma once

#include "printing/PrintService.h"
#include "project/ProfileLibrary.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QRadioButton;

namespace dipwright {

class PictureView;

class CalibrationDialog : public QDialog {
    Q_OBJECT

public:
    explicit CalibrationDialog(const ProfileLibrary& library, QWidget* parent = nullptr);

    CalibrationPage page() const; // the chosen page

signals:
    void calibrated(const PrinterProfile& profile);

private:
    QWidget* makePageChoices();
    QWidget* makeMeasurements();
    void findPrinters();
    void chooseQueue(); // selects the profile's printer
    void showPage();
    void showScale(); // computed from the typed lengths
    void print();
    void saveFile();
    void takeOver();
    void setPrinting(bool printing);
    void tell(const QString& sentence);
    void showFailure(std::exception_ptr failure);

    ProfileLibrary library_;
    PrinterProfile current_;
    QComboBox *profile_, *printer_, *paper_;
    QRadioButton *measures_, *verifies_;
    QDoubleSpinBox *x_, *y_;
    QLabel *xNominal_, *yNominal_, *scale_, *message_;
    QProgressBar* progress_;
    QPushButton *print_, *save_, *take_;
    PictureView* preview_;
    bool printing_ = false;
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
