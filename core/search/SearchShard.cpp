#include "search/SearchShard.h"

#include "search/JudgedPose.h"

#include "base/Error.h"
#include "base/Sha256.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>
#include <algorithm>
#include <bit>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

constexpr quint32 signature = 0x44505350; // "DPSP"
constexpr qint32 partVersion = 4;
constexpr qsizetype hashBytes = 32; // SHA-256 of all other bytes, at the end
constexpr int longestKey = 64, mostParts = 1000;
constexpr qint32 mostPoses = 2000, mostSamples = 100'000;
constexpr qsizetype mostBytes = 2'000'000'000;

Error damaged(const QString& where) {
    return {Text::tr("This file holds no part of a pose search, or it is damaged; create it again "
                     "with --shard"),
            where};
}

void write(QDataStream& out, const JudgedPose& pose) {
    for (const Degrees angle : pose.immersion.rotation) {
        out << angle.value();
    }
    for (const Millimetres offset : pose.immersion.offset) {
        out << offset.value();
    }
    out << pose.trappedAir << pose.filmUsed << pose.cell << qint32(pose.samples.size());
    for (std::size_t index = 0; index < pose.samples.size(); ++index) {
        const PaintedSample& sample = pose.samples[index];
        out << quint16(sample.larger) << quint16(sample.smaller) << quint8(sample.marks)
            << std::bit_cast<quint32>(pose.rests[index].x())
            << std::bit_cast<quint32>(pose.rests[index].y());
    }
}

std::shared_ptr<const JudgedPose> read(QDataStream& in, const QString& where) {
    JudgedPose pose;
    const auto number = [&](double most) {
        double value = 0;
        in >> value;
        if (!(std::abs(value) <= most)) {
            throw damaged(where);
        }
        return value;
    };
    const auto coordinate = [&] { // on the flat film, mm
        quint32 bits = 0;
        in >> bits;
        const auto value = std::bit_cast<float>(bits);
        if (!(std::abs(value) <= 1e6F)) {
            throw damaged(where);
        }
        return value;
    };
    for (Degrees& angle : pose.immersion.rotation) {
        angle = Degrees(number(360));
    }
    for (Millimetres& offset : pose.immersion.offset) {
        offset = Millimetres(number(1e6));
    }
    pose.trappedAir = number(2);
    pose.filmUsed = number(2);
    pose.cell = number(1e6);
    qint32 count = 0;
    in >> count;
    if (in.status() != QDataStream::Ok || count < 0 || count > mostSamples) {
        throw damaged(where);
    }
    for (qint32 index = 0; index < count && in.status() == QDataStream::Ok; ++index) {
        quint16 larger = 0, smaller = 0;
        quint8 marks = 0;
        in >> larger >> smaller >> marks;
        pose.samples.push_back({larger, smaller, marks});
        const float x = coordinate();
        pose.rests.emplace_back(x, coordinate());
    }
    return std::make_shared<const JudgedPose>(std::move(pose));
}

} // namespace

QByteArray shardFile(const SearchShard& shard) {
    QByteArray body;
    QDataStream out(&body, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_0);
    out << signature << partVersion << shard.key << qint32(shard.number) << qint32(shard.count)
        << qint32(shard.poses.size());
    for (const auto& pose : shard.poses) {
        write(out, *pose);
    }
    return body + sha256(body);
}

bool isShardFile(const QByteArray& file) {
    quint32 found = 0;
    QDataStream(file) >> found;
    return found == signature;
}

SearchShard shardFromFile(const QByteArray& file, const QString& where) {
    if (file.size() > mostBytes) {
        throw damaged(where);
    }
    const QByteArray body = file.chopped(std::min(hashBytes, file.size()));
    QDataStream in(body);
    in.setVersion(QDataStream::Qt_6_0);
    quint32 found = 0;
    qint32 version = 0, number = 0, count = 0, poses = 0;
    SearchShard shard;
    in >> found >> version;
    if (found == signature && in.status() == QDataStream::Ok && version != partVersion) {
        throw Error(Text::tr("This part of a pose search is from another version of the program; "
                             "create it again with --shard"),
                    where);
    }
    if (found != signature || sha256(body) != file.last(std::min(hashBytes, file.size()))) {
        throw damaged(where);
    }
    in >> shard.key >> number >> count >> poses;
    if (in.status() != QDataStream::Ok || shard.key.size() > longestKey || number < 1 ||
        number > count || count > mostParts || poses < 0 || poses > mostPoses) {
        throw damaged(where);
    }
    shard.number = number;
    shard.count = count;
    for (qint32 pose = 0; pose < poses; ++pose) {
        shard.poses.push_back(read(in, where));
    }
    if (in.status() != QDataStream::Ok || !in.atEnd()) {
        throw damaged(where);
    }
    return shard;
}

} // namespace dipwright
