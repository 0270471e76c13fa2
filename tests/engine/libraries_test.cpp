// Libraries and values that scripts use: buffers, packed strings, vectors, dates, the time of day.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

TEST(Libraries, ABufferKeepsNumbersAndText) {
  EXPECT_EQ(
      resultOf("local b = buffer.create(16)\n"
               "buffer.writeu8(b, 0, 7) buffer.writei16(b, 1, -300) buffer.writeu32(b, 3, 4e9)\n"
               "buffer.writef64(b, 7, 0.1)\n"
               "result = buffer.readu8(b, 0) .. ' ' .. buffer.readi16(b, 1) .. ' ' .. "
               "buffer.readu32(b, 3) .. ' ' .. buffer.readf64(b, 7) .. ' ' .. buffer.len(b) .. "
               "typeof(b) .. type(b)"),
      "7 -300 4000000000 0.1 16bufferbuffer");
  EXPECT_EQ(
      resultOf("local b = buffer.fromstring('hello') buffer.copy(b, 0, buffer.fromstring('J'))\n"
               "buffer.fill(b, 4, 33) result = buffer.tostring(b)"),
      "Jell!");
  EXPECT_EQ(resultOf("local b = buffer.create(2) buffer.writebits(b, 3, 7, 85)\n"
                     "result = buffer.readbits(b, 3, 7) .. ' ' .. buffer.readu16(b, 0)"),
            "85 680");
  EXPECT_NE(resultOf("buffer.readu16(buffer.create(1), 0)").find("out of bounds"),
            std::string::npos);
}

TEST(Libraries, StringsArePacked) {
  EXPECT_EQ(
      resultOf("local s = string.pack('<I2 >i4 z s1 d', 258, -2, 'ab', 'cde', 1.5)\n"
               "result = #s .. ' ' .. table.concat({string.unpack('<I2 >i4 z s1 d', s)}, ',')"),
      "21 258,-2,ab,cde,1.5,22");
  EXPECT_EQ(resultOf("result = string.packsize('!4 i1 i4')"), "8");
}

TEST(Libraries, VectorsHaveALibrary) {
  EXPECT_EQ(resultOf("result = tostring(vector.abs(vector.create(-1, 2, -3))) .. ' ' .. "
                     "vector.dot(vector.one, vector.create(1, 2, 3)) .. ' ' .. "
                     "vector.magnitude(vector.create(3, 4))"),
            "1, 2, 3 6 5");
  EXPECT_EQ(resultOf("result = tostring(Vector3.FromNormalId(Enum.NormalId.Top)) .. ' ' .. "
                     "tostring(Vector3.FromAxis(Enum.Axis.Z))"),
            "0, 1, 0 0, 0, 1");
  EXPECT_EQ(resultOf("local a = CFrame.fromRotationBetweenVectors(Vector3.xAxis, Vector3.yAxis)\n"
                     "result = math.round(math.deg(a:AngleBetween(CFrame.identity))) .. ' ' .. "
                     "Vector2.new(1, 2):Cross(Vector2.new(3, 4))"),
            "90 -2");
}

TEST(Libraries, DatesFollowTheClock) {
  EXPECT_EQ(resultOf("result = DateTime.now().UnixTimestamp - os.time() .. ' ' .. "
                     "DateTime.fromUnixTimestamp(86400):ToIsoDate() .. ' ' .. "
                     "DateTime.fromUniversalTime(2020, 2, 3):ToUniversalTime().Day"),
            "0 1970-01-02T00:00:00Z 3");
}

TEST(Libraries, EveryPlaceHasTerrain) {
  EXPECT_EQ(resultOf("workspace.Terrain:FillBall(Vector3.zero, 4, Enum.Material.Rock)\n"
                     "result = workspace:FindFirstChildOfClass('Terrain').Name"),
            "Terrain");
}

TEST(Libraries, ACopyOfAnInstanceLeavesItsChildren) {
  EXPECT_EQ(resultOf("local p = Instance.new('Part') p.Name = 'A' Instance.new('Fire', p)\n"
                     "local q = Instance.fromExisting(p) result = q.Name .. #q:GetChildren() .. "
                     "#p:GetChildren()"),
            "A01");
}

TEST(Libraries, AScriptFindsItsActor) {
  Place place;
  const InstanceId actor = place.add("Actor", "Actor", place.workspace);
  place.script("workspace.Gravity = script:GetActor() == script.Parent and 50 or 60", actor);
  engine::Stage stage(place.document, {});
  stage.start();
  EXPECT_FLOAT_EQ(float(stage.observation().player.gravity), 50);
}

TEST(Libraries, ClockTimeAndTimeOfDayShareOneValue) {
  EXPECT_EQ(
      resultOf("local l = game.Lighting result = l.ClockTime .. ' ' .. l.TimeOfDay\n"
               "l.TimeOfDay = '06:30:00' result = result .. ' ' .. l.ClockTime\n"
               "l:SetMinutesAfterMidnight(90) result = result .. ' ' .. l.TimeOfDay .. ' ' .. "
               "l:GetMinutesAfterMidnight()"),
      "14 14:00:00 6.5 01:30:00 90");
}

TEST(Libraries, TheFilesTimeOfDayCounts) {
  Place place;
  const InstanceId lighting = place.add("Lighting", "Lighting", kNoInstance);
  place.set(lighting, "TimeOfDay", std::string("21:00:00"));
  place.script("workspace.Gravity = game.Lighting.ClockTime", place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  EXPECT_FLOAT_EQ(float(stage.observation().player.gravity), 21);
}

TEST(Libraries, AMissingFeatureMakesAFailureLimited) {
  Place place;
  place.script("SharedTable.new()", place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  ASSERT_EQ(stage.observation().problems.size(), 1u);
  EXPECT_EQ(stage.observation().problems[0].failure, engine::Failure::limited);
}

TEST(Libraries, AnErrorThatIsNoStringIsAProblem) {
  Place place;
  place.script("error({})", place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  ASSERT_EQ(stage.observation().problems.size(), 1u);
  EXPECT_EQ(stage.observation().problems[0].text,
            "it raised an error that is not a string (type table)");
}

}  // namespace
}  // namespace obby::test
