// The page of a job's measured parts: their repeating error, and a preview of the correction of the
// next sheets.
#pragma once

#include "accuracy/correction/RepeatingError.h"
#include "base/Units.h"

#include <QWidget>
#include <memory>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace dipwright {

class NumberBox;
class PicturePanel;

class BuiltPage : public QWidget {
    Q_OBJECT

public:
    explicit BuiltPage(QWidget* parent = nullptr);

    // Sets the job's measured parts, the keys of its dips (dipKeys()) and the size of its film.
    void setBuilt(const AsBuilt& built, const QStringList& dips, Millimetres width,
                  Millimetres height);
    // Sets the repeating error of each dip; null: unknown.
    void setErrors(std::shared_ptr<const std::vector<RepeatingError>> errors);
    // Sets whether there is a measured part to keep.
    void setKeepable(bool keepable);
    void setBusy(bool busy);

signals:
    void keepAsked(const QString& acceptedBy);
    void correctsChosen(bool corrects);
    void strengthChosen(double strength); // 0 to 1

private:
    QWidget* makeKeepBar();
    QWidget* makeCorrectionBar();
    void showParts(const QStringList& dips);
    void showTimes();
    void showPicture();
    void enable();

    AsBuilt built_;
    Millimetres width_{210}, height_{297};
    std::shared_ptr<const std::vector<RepeatingError>> errors_;
    bool keepable_ = false, busy_ = false;
    QTableWidget *parts_, *times_;
    QLineEdit* acceptedBy_;
    QPushButton* keep_;
    QCheckBox* corrects_;
    NumberBox* strength_;
    QComboBox* dip_;
    QLabel *hint_, *words_, *legend_;
    PicturePanel* picture_;
};

} // namespace dipwright
