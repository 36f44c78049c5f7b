// What a click on the body in the view marks, how far round it, and the marks that there are.
#pragma once

#include "workbench/document/MarkEdits.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace dipwright {

class MarkFields : public QWidget {
    Q_OBJECT

public:
    // `name` is the start of the fields' object names.
    MarkFields(const QString& name, LengthUnit unit, QWidget* parent);

    virtual MarkBrush brush() const = 0;
    void setMarkCount(std::size_t count);

signals:
    void changed(); // the brush
    void removeLastAsked();
    void removeAllAsked();

protected:
    // What a click marks; its first entry, which is there already, is nothing.
    QComboBox& kind() { return *kind_; }
    const QComboBox& kind() const { return *kind_; }
    static constexpr int noKind = -1; // the first entry's data
    Millimetres radius() const;
    void setRadiusEnabled(bool enabled);
    // Fields between the kind and the radius, or without a name below it.
    QFormLayout& form() { return *form_; }
    static constexpr int radiusRow = 1; // as long as nothing was put in between

private:
    LengthUnit unit_;
    QFormLayout* form_;
    QComboBox* kind_;
    QDoubleSpinBox* radius_;
    QLabel* count_;
    QPushButton* removeLast_;
    QPushButton* removeAll_;
};

} // namespace dipwright
