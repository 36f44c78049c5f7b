// The fields that set which zone the next click on the body marks.
#pragma once

#include "workbench/widgets/MarkFields.h"

namespace dipwright {

class ZoneFields : public MarkFields {
    Q_OBJECT

public:
    explicit ZoneFields(LengthUnit unit, QWidget* parent = nullptr);

protected:
    MarkBrush chosen() const override;

private:
    QComboBox* extent_;
};

} // namespace dipwright
