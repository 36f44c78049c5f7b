// One value of a project or a profile as an editor: spin boxes, a choice, a tick or a line of text,
// made from the rule that its schema gives for it.
#pragma once

#include "project/Field.h"
#include "workbench/widgets/Units.h"

#include <QWidget>
#include <functional>
#include <memory>

namespace dipwright {

struct Project;

// How a value of the schema is called and explained to the user.
struct PropertySpec {
    QString path;
    QString label;
    QString help; // a sentence or two: what it is and what it does
    Unit unit = Unit::None;
    QStringList parts = {};            // short names where the value has several: "X", "Y"
    QMap<QString, QString> words = {}; // the schema's choices in the user's language
    QString absent = {};               // what no value means, where there may be none: "Elastic"
    double whenPresent = 1;            // the value when the user asks for one
    std::function<bool(const Project&)> relevant = {}; // empty: always shown
    // Of several parts that usually are one number: typing one of them sets all, as long as the
    // user does not unlink them.
    bool linked = false;
    bool isColour = false; // of a text: "#rrggbb", which a dialog may choose as well
};

class PropertyField : public QWidget {
    Q_OBJECT

public:
    static PropertyField* make(const PropertySpec& spec, const FieldRule& rule, LengthUnit length,
                               QWidget* parent);

    virtual void show(const QJsonValue& value) = 0; // emits nothing
    const PropertySpec& spec() const { return spec_; }

signals:
    void edited(const QJsonValue& value);
    void left();                           // the user has turned to something else
    void refused(const QString& sentence); // what was typed was not accepted

protected:
    PropertyField(const PropertySpec& spec, QWidget* parent) : QWidget(parent), spec_(spec) {}
    // Names and explains an editor, and watches it being left.
    void adopt(QWidget* editor, const QString& name, const QString& range);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    PropertySpec spec_;
};

} // namespace dipwright
