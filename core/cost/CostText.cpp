#include "cost/CostText.h"

#include "base/NumberText.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cost)
};

const char* keyOf(CostKind kind) {
    constexpr std::array keys{"film", "ink", "labour"};
    return keys[std::size_t(kind)];
}

const char* keyOf(CostUnit unit) {
    constexpr std::array keys{"m2", "roll metre", "sheet", "ml", "h"};
    return keys[std::size_t(unit)];
}

const char* keyOf(TimeKind kind) {
    constexpr std::array keys{"set_up", "handling", "soak",  "activator",
                              "motion", "flash",    "drying"};
    return keys[std::size_t(kind)];
}

// Returns the name of an ink for the user; spot inks keep their own.
QString shownInk(const QString& ink) {
    return ink == QLatin1String("Cyan")      ? Text::tr("Cyan")
           : ink == QLatin1String("Magenta") ? Text::tr("Magenta")
           : ink == QLatin1String("Yellow")  ? Text::tr("Yellow")
           : ink == QLatin1String("Black")   ? Text::tr("Black")
                                             : ink;
}

QString wordFor(const CostItem& item) {
    switch (item.kind) {
    case CostKind::Film:
        return Text::tr("Film");
    case CostKind::Ink:
        return Text::tr("Ink: %1").arg(shownInk(item.ink));
    case CostKind::Labour:
        break;
    }
    return Text::tr("Work");
}

QString wordFor(TimeKind kind) {
    switch (kind) {
    case TimeKind::SetUp:
        return Text::tr("Set-up");
    case TimeKind::Handling:
        return Text::tr("Handling");
    case TimeKind::Soak:
        return Text::tr("Soak");
    case TimeKind::Activator:
        return Text::tr("Activator");
    case TimeKind::Motion:
        return Text::tr("Dip");
    case TimeKind::Flash:
        return Text::tr("Flash, each rack");
    case TimeKind::Drying:
        break;
    }
    return Text::tr("Drying, each rack");
}

QString shown(double number) {
    const int decimals = number < 1 ? 4 : number < 100 ? 2 : 1;
    return numberText(number, decimals);
}

QString shownAmount(double amount, CostUnit unit) {
    const QString number = shown(amount);
    switch (unit) {
    case CostUnit::SquareMetre:
        return Text::tr("%1 m²").arg(number);
    case CostUnit::RollMetre:
        return Text::tr("%1 m of roll").arg(number);
    case CostUnit::Sheet:
        return Text::tr("%1 sheets").arg(number);
    case CostUnit::Millilitre:
        return Text::tr("%1 ml").arg(number);
    case CostUnit::Hour:
        break;
    }
    return Text::tr("%1 h").arg(number);
}

QString money(double amount, const QString& currency) {
    const QString number = numberText(amount, 2);
    return currency.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, currency);
}

// Returns what the cell of an item without cost says.
QString shortMissing(const CostItem& item) {
    return item.amount ? Text::tr("no price") : Text::tr("no ml/m²");
}

QString missingOf(TimeKind kind) {
    switch (kind) {
    case TimeKind::SetUp:
        return Text::tr("no time for the set-up");
    case TimeKind::Handling:
        return Text::tr("no time for handling");
    case TimeKind::Soak:
        return Text::tr("no soak time");
    case TimeKind::Activator:
        return Text::tr("no activator time");
    case TimeKind::Motion:
        return {};
    case TimeKind::Flash:
        return Text::tr("no flash time");
    case TimeKind::Drying:
        break;
    }
    return Text::tr("no drying time");
}

QJsonValue orNull(const std::optional<double>& number) {
    return number ? QJsonValue(*number) : QJsonValue();
}

QString csvField(QString text) {
    if (text.contains(u',') || text.contains(u'"')) {
        text = QStringLiteral("\"%1\"").arg(text.replace(u'"', QStringLiteral("\"\"")));
    }
    return text;
}

QString csvNumber(const std::optional<double>& number) {
    return number ? QString::number(*number, 'g', 10) : QString();
}

void addCsv(QString& csv, const QString& project, const OrderCost& order) {
    const auto line = [&](const char* kind, const QString& name, std::optional<double> amount,
                          const char* unit, std::optional<double> price,
                          std::optional<double> cost) {
        csv += QStringList{csvField(project),         QString::number(order.parts),
                           QString::fromLatin1(kind), csvField(name),
                           csvNumber(amount),         QString::fromLatin1(unit),
                           csvNumber(price),          csvNumber(cost),
                           csvField(order.currency)}
                   .join(u',') +
               u'\n';
    };
    for (const CostItem& item : order.items) {
        line(keyOf(item.kind), item.ink, item.amount, keyOf(item.unit), item.price, item.cost());
    }
    for (const TimeItem& time : order.times) {
        line(keyOf(time.kind), {}, time.time ? std::optional(time.time->value()) : std::nullopt,
             "s", {}, {});
    }
    line("work", {}, order.work.value(), "s", {}, {});
    line("elapsed", {}, order.elapsed.value(), "s", {}, {});
    line("sheets", {}, order.sheets, "sheet", {}, {});
    line("sum", {}, {}, "", {},
         order.isComplete() ? std::optional(order.known) : std::optional<double>());
}

} // namespace

QString durationText(Seconds time) {
    constexpr int perMinute = 60, perHour = 60, perDay = 24;
    const auto seconds = qint64(std::llround(time.value()));
    const qint64 minutes = (seconds + perMinute / 2) / perMinute;
    const qint64 hours = minutes / perHour;
    if (seconds < 2 * perMinute) {
        return Text::tr("%1 s").arg(seconds);
    }
    if (hours == 0) {
        return Text::tr("%1 min").arg(minutes);
    }
    if (hours < 2 * perDay) {
        return Text::tr("%1 h %2 min").arg(hours).arg(minutes % perHour);
    }
    const qint64 rounded = (minutes + perHour / 2) / perHour;
    return Text::tr("%1 days %2 h").arg(rounded / perDay).arg(rounded % perDay);
}

std::vector<CostRow> costRows(const OrderCost& cost) {
    std::vector<CostRow> rows;
    for (const CostItem& item : cost.items) {
        const std::optional<double> price = item.cost();
        rows.push_back({wordFor(item),
                        item.amount ? shownAmount(*item.amount, item.unit) : QString(),
                        price ? money(*price, cost.currency) : shortMissing(item)});
    }
    if (cost.hasPrices()) {
        rows.push_back({cost.isComplete() ? Text::tr("Sum") : Text::tr("Sum of the known prices"),
                        {},
                        money(cost.known, cost.currency)});
    }
    return rows;
}

std::vector<CostRow> timeRows(const OrderCost& cost) {
    std::vector<CostRow> rows;
    for (const TimeItem& item : cost.times) {
        rows.push_back(
            {wordFor(item.kind), item.time ? durationText(*item.time) : missingOf(item.kind), {}});
    }
    rows.push_back({Text::tr("Working time"), durationText(cost.work), {}});
    rows.push_back({Text::tr("Until the last part is dry"), durationText(cost.elapsed), {}});
    return rows;
}

QStringList missingPrices(const OrderCost& cost) {
    QStringList missing, withoutAmount, withoutPrice;
    for (const CostItem& item : cost.items) {
        if (item.kind == CostKind::Ink && !item.amount) {
            withoutAmount << shownInk(item.ink);
        } else if (item.kind == CostKind::Ink && !item.price) {
            withoutPrice << shownInk(item.ink);
        } else if (!item.cost()) {
            missing << (item.kind == CostKind::Film ? Text::tr("no price for the film")
                                                    : Text::tr("no price for an hour of work"));
        }
    }
    const QString comma = QStringLiteral(", ");
    if (!withoutAmount.isEmpty()) {
        missing << Text::tr("no amount in ml/m² for ink: %1").arg(withoutAmount.join(comma));
    }
    if (!withoutPrice.isEmpty()) {
        missing << Text::tr("no price for ink: %1").arg(withoutPrice.join(comma));
    }
    return missing;
}

QStringList missingTimes(const OrderCost& cost) {
    QStringList missing;
    for (const TimeItem& item : cost.times) {
        if (!item.time) {
            missing << missingOf(item.kind);
        }
    }
    return missing;
}

QString costSentence(const OrderCost& cost) {
    QString sentence = Text::tr("Parts: %1, sheets: %2").arg(cost.parts).arg(cost.sheets);
    if (cost.hasPrices()) {
        sentence += QStringLiteral(", ") + Text::tr("cost: %1, for each part: %2")
                                               .arg(money(cost.known, cost.currency),
                                                    money(cost.known / cost.parts, cost.currency));
    }
    if (!cost.isComplete()) {
        sentence += QStringLiteral(" (%1)").arg(missingPrices(cost).join(QStringLiteral("; ")));
    }
    return sentence + QStringLiteral(", ") +
           Text::tr("working time: %1, until the last part is dry: %2")
               .arg(durationText(cost.work), durationText(cost.elapsed));
}

QJsonObject costJson(const OrderCost& cost) {
    QJsonArray items, times;
    for (const CostItem& item : cost.items) {
        QJsonObject one{{"kind", keyOf(item.kind)},
                        {"amount", orNull(item.amount)},
                        {"unit", keyOf(item.unit)},
                        {"price", orNull(item.price)},
                        {"cost", orNull(item.cost())}};
        if (item.kind == CostKind::Ink) {
            one.insert(QStringLiteral("ink"), item.ink);
        }
        items.append(one);
    }
    for (const TimeItem& item : cost.times) {
        times.append(
            QJsonObject{{"kind", keyOf(item.kind)},
                        {"seconds", item.time ? QJsonValue(item.time->value()) : QJsonValue()}});
    }
    return {{"parts", cost.parts},
            {"racks", cost.racks},
            {"sheets", cost.sheets},
            {"currency", cost.currency},
            {"items", items},
            {"inks_estimated", cost.areInksEstimated},
            {"times", times},
            {"work_s", cost.work.value()},
            {"elapsed_s", cost.elapsed.value()},
            {"known", cost.known},
            {"complete", cost.isComplete()},
            {"missing", QJsonArray::fromStringList(missingPrices(cost) + missingTimes(cost))}};
}

QByteArray costCsv(const std::vector<ProjectCost>& projects) {
    QString csv = QStringLiteral("project,parts,kind,name,amount,unit,price,cost,currency\n");
    for (const ProjectCost& project : projects) {
        for (const OrderCost& order : project.orders) {
            addCsv(csv, project.project, order);
        }
    }
    return csv.toUtf8();
}

} // namespace dipwright
