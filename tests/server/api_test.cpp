#include "server/api.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/clock.hpp"
#include "core/json_object.hpp"
#include "server/password.hpp"
#include "tests/eventually.hpp"
#include "tests/server/served.hpp"

namespace rva {
namespace {

using testing::HasSubstr;

class Asked : public testing::Test {
 protected:
  ApiResponse ask(const std::string& method, const std::string& path, const std::string& body = "",
                  const std::string& query = "") const {
    return api_.answer({method, path, body, "client-of-this-test", token_, "here", query});
  }
  std::size_t listed(const std::string& query) const {
    return Json::parse(ask("GET", "/api/inspections", "", query).body)["inspections"].size();
  }
  std::string code(const std::string& method, const std::string& path, const std::string& body = "") const {
    return Json::parse(ask(method, path, body).body)["error"]["code"];
  }
  void sign_in(PersonRole role) {
    served_.records.set_account({"ann", role, hash_password("correct horse")});
    const ApiResponse answer = ask("POST", "/api/sign-in", R"({"name":"ann","password":"correct horse"})");
    ASSERT_EQ(answer.status, 200);
    const std::string cookie = answer.headers.at(0).second;
    token_ = cookie.substr(cookie.find('=') + 1, 64);
    EXPECT_THAT(cookie, HasSubstr("HttpOnly"));
    EXPECT_THAT(cookie, HasSubstr("SameSite=Strict"));
    EXPECT_THAT(cookie, HasSubstr("Secure"));
  }

  test::Served served_;
  Api api_{served_.parts(), true};
  std::string token_;
};

TEST_F(Asked, AnInspectionIsBegunListedAndGivenItsViews) {
  const ApiResponse begun = ask("POST", "/api/inspections", R"({"aircraft":"N1","person":"Ann"})");
  EXPECT_EQ(begun.status, 201);
  EXPECT_EQ(Json::parse(begun.body)["stage"], "baseline");
  EXPECT_EQ(ask("PUT", "/api/inspections/1/views", R"({"views":[{"pan_deg":1,"tilt_deg":-2}]})").status, 200);
  const Json inspection = Json::parse(ask("GET", "/api/inspections/1").body);
  EXPECT_EQ(inspection["views"][0]["tilt_deg"], -2.0);
  EXPECT_EQ(Json::parse(ask("GET", "/api/inspections").body)["inspections"].size(), 1U);
}

TEST_F(Asked, AListIsFiltered) {
  for (const char* const zone : {"left wing", "right wing", "tail"})
    ask("POST", "/api/inspections", Json{{"person", "Ann"}, {"zone", zone}}.dump());
  EXPECT_EQ(listed(""), 3U);
  EXPECT_EQ(listed("text=wing+left"), 1U);
  EXPECT_EQ(listed("text=le%66t&most=5"), 1U);
  EXPECT_EQ(listed("most=2"), 2U);
  EXPECT_EQ(listed("before=3&stage=baseline"), 2U);
  EXPECT_EQ(listed("stage=done"), 0U);
  EXPECT_EQ(listed("from=2000-01-01&until=2001-01-01"), 0U);
  for (const char* const query : {"most=0", "most=x", "most=99999", "before=-1", "stage=maybe", "colour=red",
                                  "text=%zz", "text=%", "text=%0a"})
    EXPECT_EQ(ask("GET", "/api/inspections", "", query).status, 400) << query;
  EXPECT_EQ(ask("GET", "/api/inspections", "", "text=" + std::string(300, 'x')).status, 400);
}

TEST_F(Asked, AnEmptyInspectionIsRemoved) {
  ask("POST", "/api/inspections", R"({"person":"Ann"})");
  EXPECT_EQ(ask("DELETE", "/api/inspections/1").status, 200);
  EXPECT_EQ(ask("GET", "/api/inspections/1").status, 404);
}

TEST_F(Asked, WhatIsSeenInTheLivePictureIsMarked) {
  ASSERT_TRUE(test::eventually([&] { return served_.camera.newest() != nullptr; }));
  ask("POST", "/api/inspections", R"({"person":"Ann"})");
  const std::string path = "/api/inspections/1/marked";
  const ApiResponse answer =
      ask("POST", path, R"({"stream":"depth","bbox":[20,60,10,10],"note":"a rag","person":"Ann"})");
  ASSERT_EQ(answer.status, 201) << answer.body;
  const Json marked = Json::parse(answer.body)["marked"].at(0);
  EXPECT_EQ(marked["note"], "a rag");
  EXPECT_EQ(marked["bbox"].dump(), "[20,60,10,10]");
  EXPECT_TRUE(marked.contains("position_m"));
  EXPECT_FALSE(marked.contains("view"));
  EXPECT_EQ(ask("GET", path + "/1/picture.png").status, 200);
  EXPECT_EQ(ask("GET", path + "/2/picture.png").status, 404);
  for (const char* const body : {R"({"stream":"depth","bbox":[20,60,10,10],"person":""})",
                                 R"({"stream":"depth","bbox":[20,60,1e8,10],"person":"Ann"})",
                                 R"({"stream":"depth","bbox":[-1,60,10,10],"person":"Ann"})",
                                 R"({"stream":"depth","bbox":[1,2,3],"person":"Ann"})",
                                 R"({"stream":"sonar","bbox":[20,60,10,10],"person":"Ann"})",
                                 R"({"stream":"color","bbox":[20,60,10,10],"person":"Ann"})",
                                 R"({"comparison":1,"view":0,"bbox":[20,60,10,10],"person":"Ann"})"})
    EXPECT_GE(ask("POST", path, body).status, 400) << body;
  const auto named =
      ask("POST", path + "/1/decision", R"({"verdict":"debris","note":"","object":"rag","person":"Ann"})");
  EXPECT_EQ(named.status, 200);
  EXPECT_EQ(Json::parse(named.body)["marked"][0]["decision"]["object"], "rag");
  EXPECT_EQ(ask("POST", path + "/1/decision", R"({"verdict":"debris","object":7,"person":"Ann"})").status,
            400);
  EXPECT_EQ(ask("POST", path + "/2/decision", R"({"verdict":"debris","note":"","person":"Ann"})").status,
            409);
  const std::string together = "/api/inspections/1/decisions";
  for (const char* const decisions :
       {"7", "[7]", R"([{"verdict":"debris"}])", R"([{"mark":1,"finding":1,"verdict":"debris"}])",
        R"([{"mark":1,"verdict":"maybe"}])",
        R"([{"mark":1,"verdict":"undecided"},{"mark":2,"verdict":"debris"}])",
        R"([{"mark":1.5,"verdict":"undecided"}])", "[]"})
    EXPECT_GE(ask("POST", together, std::string(R"({"person":"Ann","decisions":)") + decisions + "}").status,
              400)
        << decisions;
  EXPECT_TRUE(Json::parse(ask("GET", "/api/inspections/1").body)["marked"][0].contains("decision"));
  const ApiResponse withdrawn =
      ask("POST", together, R"({"person":"Ann","decisions":[{"mark":1,"verdict":"undecided"}]})");
  EXPECT_FALSE(Json::parse(withdrawn.body)["marked"][0].contains("decision"));
  EXPECT_EQ(code("POST", "/api/inspections/1/close", R"({"comparison":1,"person":"Ann"})"), "refused");
  EXPECT_EQ(Json::parse(ask("GET", "/api/inspections/1/rounds").body)["rounds"].size(), 0U);
  EXPECT_EQ(ask("GET", "/api/inspections/1/rounds/1/views/0/final_color.png").status, 404);
}

TEST_F(Asked, RegionsToLeaveOutNeedABaselineAndPolygons) {
  ASSERT_EQ(ask("POST", "/api/inspections", R"({"person":"Ann"})").status, 201);
  const std::string path = "/api/inspections/1/regions";
  EXPECT_EQ(ask("PUT", path, R"({"view":0,"ignore":[[[0,0],[5,0],[0,5]]]})").status, 409) << "no baseline";
  EXPECT_EQ(ask("GET", "/api/inspections/1/baseline/0/depth.png").status, 404);
  served_.records.set_side(1, Side::initial, {"t", "Ann", "b"});
  const ApiResponse kept = ask("PUT", path, R"({"view":0,"ignore":[[[0,0],[5.5,0],[0,5]]]})");
  EXPECT_EQ(kept.status, 200);
  EXPECT_EQ(Json::parse(kept.body)["views"][0]["ignore"].dump(), "[[[0.0,0.0],[5.5,0.0],[0.0,5.0]]]");
  EXPECT_EQ(code("PUT", path, R"({"view":0})"), "bad-request");
  for (const char* const body :
       {R"({"view":7,"ignore":[]})", R"({"view":-1,"ignore":[]})", R"({"view":1e99,"ignore":[]})",
        R"({"view":0,"ignore":7})", R"({"view":0,"ignore":[[[0,0],[1,1]]]})",
        R"({"view":0,"ignore":[[[0,0],[1,1],["x",2]]]})"})
    EXPECT_GE(ask("PUT", path, body).status, 400) << body;
  EXPECT_EQ(Json::parse(ask("GET", "/api/inspections/1").body)["views"][0]["ignore"].size(), 1U)
      << "as before";
  EXPECT_FALSE(
      Json::parse(ask("PUT", path, R"({"view":0,"ignore":[]})").body)["views"][0].contains("ignore"));
  for (const char* const picture : {"1/depth.png", "x/depth.png", "0/secret.png", "-1/depth.png"})
    EXPECT_GE(ask("GET", std::string("/api/inspections/1/baseline/") + picture).status, 400) << picture;
}

TEST_F(Asked, APlanIsAPlanFile) {
  ASSERT_EQ(ask("POST", "/api/inspections", R"({"person":"Ann"})").status, 201);
  served_.records.set_side(1, Side::initial, {"t", "Ann", "b"});
  const std::string path = "/api/inspections/1/views/0/plan";
  const std::string part = R"({"name":"collar","count":1,"height_mm":[8,10],"areas":[[[0,0],[9,0],[9,9]]]})";
  const auto request = [](const std::string& parts) {
    return json_text(Json{{"text", R"({"format":"rva-plan","version":1,"parts":[)" + parts + "]}"}});
  };
  const ApiResponse kept = ask("PUT", path, request(part));
  EXPECT_EQ(kept.status, 200);
  const Json plan = Json::parse(kept.body)["views"][0]["plan"];
  EXPECT_EQ(plan["coordinates"], "pixels");
  EXPECT_EQ(plan["parts"][0]["name"], "collar");
  EXPECT_EQ(plan["parts"][0]["areas"][0].size(), 3U);
  EXPECT_EQ(code("PUT", path, request(part + "," + part)), "refused") << "two of one name";
  EXPECT_EQ(code("PUT", path, R"({"text":"no plan"})"), "refused");
  EXPECT_EQ(code("PUT", path, R"({"text":7})"), "bad-request");
  EXPECT_EQ(code("PUT", "/api/inspections/1/views/7/plan", request(part)), "refused");
  EXPECT_EQ(ask("PUT", "/api/inspections/1/views/x/plan", request(part)).status, 404);
  EXPECT_EQ(Json::parse(ask("GET", "/api/inspections/1").body)["views"][0]["plan"], plan) << "as before";
  EXPECT_FALSE(Json::parse(ask("PUT", path, R"({"text":""})").body)["views"][0].contains("plan"));
}

TEST_F(Asked, WhatIsMissingOrMalformedIsSaidWithACode) {
  EXPECT_EQ(code("GET", "/api/nothing"), "not-found");
  EXPECT_EQ(code("DELETE", "/api/inspections"), "method-not-allowed");
  EXPECT_EQ(code("GET", "/api/inspections/7"), "not-found");
  for (const char* const id : {"x", "-1", "0", "1x", "99999999999999999999", "%31", ""})
    EXPECT_EQ(ask("GET", std::string("/api/inspections/") + id).status, 404) << id;
  EXPECT_EQ(code("POST", "/api/inspections", "{"), "bad-request");
  EXPECT_EQ(ask("POST", "/api/inspections", R"({"person":" "})").status, 409);
  ASSERT_EQ(ask("POST", "/api/inspections", R"({"person":"Ann"})").status, 201);
  for (const char* const body :
       {R"({})", R"({"views":1})", R"({"views":[1]})", R"({"views":[{"pan_deg":"x","tilt_deg":0}]})",
        R"({"views":[]})", R"({"views":[{"pan_deg":0,"tilt_deg":80}]})"})
    EXPECT_GE(ask("PUT", "/api/inspections/1/views", body).status, 400) << body;
  EXPECT_EQ(code("POST", "/api/inspections/1/capture", R"({"side":"middle","person":"Ann"})"), "bad-request");
  EXPECT_EQ(code("POST", "/api/inspections/1/capture", R"({"side":"final","person":"Ann"})"), "refused");
  EXPECT_EQ(code("POST", "/api/inspections/1/findings/1/decision", R"({"verdict":"maybe"})"), "bad-request");
  EXPECT_EQ(code("POST", "/api/inspections/1/findings/1zzz/decision", R"({"verdict":"false-alarm"})"),
            "not-found");
  EXPECT_EQ(code("GET", "/api/inspections/999"), "not-found");
  for (const char* const person : {R"("\n")", R"("\u200b")", R"("\u00a0")", R"("Ann\u202e")", R"(" ")"})
    EXPECT_EQ(code("POST", "/api/inspections", std::string(R"({"person":)") + person + "}"), "refused")
        << person;
  EXPECT_EQ(code("POST", "/api/simulation", R"({"done":true})"), "refused") << "the bay is real";
}

TEST_F(Asked, PicturesAreThoseOfTheListAndNoOtherFile) {
  ASSERT_EQ(ask("POST", "/api/inspections", R"({"person":"Ann"})").status, 201);
  for (const char* const name : {"0/final_color.png", "0/..%2f..%2frva.db", "0/../../../rva.db", "0/rva.db",
                                 "-1/changes.png", "x/changes.png", "0/"})
    EXPECT_EQ(ask("GET", std::string("/api/inspections/1/views/") + name).status, 404) << name;
  EXPECT_EQ(ask("GET", "/api/inspections/1/map").status, 404);
}

TEST_F(Asked, MeasuresWhatTheCameraSees) {
  ASSERT_TRUE(test::eventually([&] { return served_.camera.newest() != nullptr; }));
  const Json answer = Json::parse(
      ask("POST", "/api/measure", R"({"stream":"depth","points":[{"u":20,"v":60},{"u":140,"v":60}]})").body);
  EXPECT_NEAR(answer["length_mm"].get<double>(), 800.0 * 120.0 / 212.0, 3.0);
  EXPECT_EQ(code("POST", "/api/measure", R"({"stream":"depth","points":[]})"), "bad-request");
  EXPECT_EQ(code("POST", "/api/measure", R"({"stream":"sonar","points":[{"u":1,"v":1}]})"), "bad-request");
}

TEST_F(Asked, TheExposureIsSetWithinTheCamerasRange) {
  ASSERT_TRUE(test::eventually([&] { return served_.camera.exposure_control().has_value(); }));
  const auto set = [&] { return served_.camera.exposure_control()->set; };
  EXPECT_EQ(ask("PUT", "/api/camera/exposure", R"({"automatic":false,"time_us":4000,"gain":32})").status,
            200);
  const Exposure fixed{.automatic = false, .time_us = 4000.0, .gain = 32.0};
  EXPECT_TRUE(test::eventually([&] { return set() == fixed; }));
  for (const char* const wrong :
       {R"({"automatic":false,"time_us":0,"gain":32})", R"({"automatic":false,"time_us":1e9,"gain":32})",
        R"({"automatic":false,"time_us":4000,"gain":8})"})
    EXPECT_EQ(code("PUT", "/api/camera/exposure", wrong), "refused") << wrong;
  for (const char* const malformed : {R"({})", R"({"automatic":"yes"})", R"({"automatic":false,"gain":32})"})
    EXPECT_EQ(code("PUT", "/api/camera/exposure", malformed), "bad-request") << malformed;
  const auto seen = served_.camera.newest();
  ASSERT_TRUE(
      test::eventually([&] { return served_.camera.newest()->frame.number > seen->frame.number + 3; }));
  EXPECT_EQ(set(), fixed) << "what was refused changes nothing";
  EXPECT_EQ(ask("PUT", "/api/camera/exposure", R"({"automatic":true})").status, 200);
  EXPECT_TRUE(test::eventually([&] { return set().automatic; }));
}

TEST_F(Asked, AFrozenPictureIsShownMeasuredAndKept) {
  ASSERT_TRUE(test::eventually([&] { return served_.camera.newest() != nullptr; }));
  const ApiResponse answer = ask("POST", "/api/freeze", R"({"stream":"depth"})");
  EXPECT_EQ(answer.status, 201);
  EXPECT_EQ(Json::parse(answer.body)["frozen"], 1);
  EXPECT_EQ(ask("GET", "/api/frozen/1/picture.png").content_type, "image/png");
  const auto distance_m = [&] {
    return Json::parse(
               ask("POST", "/api/measure", R"({"stream":"depth","frozen":1,"points":[{"u":80,"v":60}]})")
                   .body)["points"][0]["distance_m"]
        .get<double>();
  };
  const double before_m = distance_m();
  served_.plug->bump_mm = 100;
  const auto seen = served_.camera.newest();
  ASSERT_TRUE(
      test::eventually([&] { return served_.camera.newest()->frame.number > seen->frame.number + 3; }));
  EXPECT_EQ(distance_m(), before_m) << "of the picture, not of what is there now";

  ASSERT_EQ(ask("POST", "/api/inspections", R"({"person":"Ann"})").status, 201);
  const ApiResponse kept = ask("POST", "/api/inspections/1/snapshots",
                               R"({"stream":"depth","frozen":1,"note":"why?","person":"Ann"})");
  EXPECT_EQ(kept.status, 201);
  EXPECT_EQ(Json::parse(kept.body)["snapshots"][0]["note"], "why?");
  EXPECT_EQ(ask("GET", "/api/inspections/1/snapshots/1/picture.png").body,
            ask("GET", "/api/frozen/1/picture.png").body);
  EXPECT_EQ(ask("POST", "/api/inspections/1/snapshots", R"({"stream":"depth","person":"Ann"})").status, 201);
  EXPECT_EQ(code("POST", "/api/inspections/1/snapshots", R"({"stream":"depth","frozen":9,"person":"Ann"})"),
            "not-found");
  EXPECT_EQ(code("POST", "/api/inspections/1/snapshots", R"({"stream":"depth"})"), "refused")
      << "nobody's name";
  EXPECT_EQ(code("POST", "/api/freeze", R"({"stream":"sonar"})"), "bad-request");
  EXPECT_EQ(ask("GET", "/api/frozen/9/picture.png").status, 404);
  EXPECT_EQ(ask("GET", "/api/frozen/x/picture.png").status, 404);
  EXPECT_EQ(ask("GET", "/api/inspections/1/snapshots/3/picture.png").status, 404);
}

TEST_F(Asked, WithoutASignInNothingIsSeen) {
  sign_in(PersonRole::inspector);
  EXPECT_EQ(ask("GET", "/api/inspections").status, 200);
  token_ = std::string(64, '0');
  EXPECT_EQ(code("GET", "/api/inspections"), "sign-in-required");
  const Json session = Json::parse(ask("GET", "/api/session").body);
  EXPECT_TRUE(session["sign_in_needed"]);
  EXPECT_FALSE(session.contains("name"));
}

TEST_F(Asked, RemovingTheLastAccountGivesNobodyAccess) {
  sign_in(PersonRole::inspector);
  EXPECT_EQ(ask("GET", "/api/inspections").status, 200);
  served_.records.remove_account("ann");
  EXPECT_EQ(code("GET", "/api/inspections"), "sign-in-required");
}

TEST_F(Asked, RolesMayDoWhatIsTheirs) {
  sign_in(PersonRole::viewer);
  EXPECT_EQ(ask("GET", "/api/inspections").status, 200);
  EXPECT_EQ(code("POST", "/api/inspections", R"({"person":"Ann"})"), "not-allowed");
  EXPECT_EQ(code("POST", "/api/readiness", "{}"), "not-allowed");
  EXPECT_EQ(code("POST", "/api/inspections/1/marked", "{}"), "not-allowed");
  EXPECT_EQ(code("DELETE", "/api/inspections/1", "{}"), "not-allowed");
  sign_in(PersonRole::operator_);
  EXPECT_EQ(ask("POST", "/api/inspections", R"({"person":"Bob"})").status, 201);
  EXPECT_EQ(Json::parse(ask("GET", "/api/inspections/1").body)["person"], "ann")
      << "an account cannot lend a name";
  EXPECT_EQ(code("POST", "/api/inspections/1/findings/1/decision", R"({"verdict":"false-alarm"})"),
            "not-allowed");
  EXPECT_EQ(code("POST", "/api/inspections/1/close", R"({"comparison":1})"), "not-allowed");
  sign_in(PersonRole::inspector);
  EXPECT_EQ(code("POST", "/api/inspections/1/findings/1/decision",
                 R"({"verdict":"false-alarm","compared_at":"t"})"),
            "refused");
}

TEST_F(Asked, ACaptureWaitsForTheDriver) {
  ASSERT_EQ(ask("POST", "/api/inspections", R"({"person":"Ann"})").status, 201);
  const double now_s = steady_clock().now_s();
  served_.lease.take({"another-client", "Bob"}, false, now_s);
  EXPECT_EQ(code("POST", "/api/inspections/1/capture", R"({"side":"initial","person":"Ann"})"),
            "somebody-drives");
  served_.lease.take({"client-of-this-test", "Ann"}, true, now_s);
  EXPECT_EQ(ask("POST", "/api/inspections/1/capture", R"({"side":"initial","person":"Ann"})").status, 202);
}

}  // namespace
}  // namespace rva
