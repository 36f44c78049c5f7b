// The page of the parts that a job keeps: what they are off again and again, and the correction of
// the next sheets by it, seen before it is used.
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

    // What the job keeps, and its sheet's size.
    void setBuilt(const AsBuilt& built, Millimetres width, Millimetres height);
    // What repeats, a dip each; null: it is not known yet.
    void setErrors(std::shared_ptr<const std::vector<RepeatingError>> errors);
    // Whether a part is measured that could be kept.
    void setKeepable(bool keepable);
    void setBusy(bool busy);

signals:
    void keepAsked(const QString& acceptedBy);
    void correctsChosen(bool corrects);
    void strengthChosen(double strength); // a share

private:
    QWidget* makeKeepBar();
    QWidget* makeCorrectionBar();
    void showParts();
    void showPicture();
    void enable();

    AsBuilt built_;
    Millimetres width_{210}, height_{297};
    std::shared_ptr<const std::vector<RepeatingError>> errors_;
    bool keepable_ = false, busy_ = false;
    QTableWidget* parts_;
    QLineEdit* acceptedBy_;
    QPushButton* keep_;
    QCheckBox* corrects_;
    NumberBox* strength_;
    QComboBox* dip_;
    QLabel *hint_, *words_, *legend_;
    PicturePanel* picture_;
};

} // namespace dipwright
