// The tables of SqliteRecords.
#pragma once

namespace rva {

/// `pragma user_version` of a file with these tables.
inline constexpr int schema_version = 9;

/// The tables of version 1. Lists within a row are JSON. Rows of `decision` are only added: the latest one of
/// a finding applies.
inline constexpr const char* schema = R"sql(
create table inspection (
  id integer primary key,
  aircraft text not null, zone text not null, work_order text not null, person text not null,
  created_at text not null,
  compared_at text not null default '',
  dither integer not null check (dither >= 1)
) strict;
create table view (
  inspection integer not null references inspection, number integer not null,
  pan_deg real not null, tilt_deg real not null,
  primary key (inspection, number)
) strict, without rowid;
create table side (
  inspection integer not null references inspection, side text not null check (side in ('initial', 'final')),
  taken_at text not null, person text not null, base text not null,
  primary key (inspection, side)
) strict, without rowid;
create table compared_view (
  inspection integer not null references inspection, view integer not null,
  method text not null, compared real not null, unseen real not null, invalid real not null, judged real not null,
  warnings text not null,
  primary key (inspection, view)
) strict, without rowid;
create table finding (
  inspection integer not null references inspection, compared_at text not null, number integer not null,
  view integer not null, same_as integer not null,
  kind text not null check (kind in ('added', 'removed')),
  box text not null, centroid text not null, position_m text, in_foot_m text, size_mm text,
  height_mm real, score real, p_value real,
  primary key (inspection, compared_at, number)
) strict, without rowid;
create table decision (
  id integer primary key,
  inspection integer not null, compared_at text not null, finding integer not null,
  verdict text not null, note text not null, person text not null, decided_at text not null,
  foreign key (inspection, compared_at, finding) references finding
) strict;
create index decision_of_finding on decision (inspection, compared_at, finding);
create table account (
  name text primary key, role text not null, password_hash text not null
) strict, without rowid;
)sql";

/// Changes from version 1 to 2: regions that are left out, and objects that were moved.
inline constexpr const char* schema_2_from_1 = R"sql(
create table ignored_region (
  inspection integer not null references inspection, view integer not null, regions text not null,
  primary key (inspection, view)
) strict, without rowid;
alter table compared_view add column left_out real;
alter table finding add column moved_from integer;
)sql";

/// Changes from version 2 to 3: sides are taken in rounds, comparisons have numbers, accounts have
/// generations. Findings and decisions belong to a comparison's number rather than to its time.
inline constexpr const char* schema_3_from_2 = R"sql(
create table comparison (
  inspection integer not null references inspection, number integer not null,
  compared_at text not null, folder text not null,
  primary key (inspection, number)
) strict, without rowid;
insert into comparison
  select inspection, row_number() over (partition by inspection order by compared_at), compared_at, ''
  from (select inspection, compared_at from finding
        union select id, compared_at from inspection where compared_at <> '');
alter table inspection add column comparison integer not null default 0;
update inspection set comparison = coalesce((select number from comparison c
  where c.inspection = inspection.id and c.compared_at = inspection.compared_at), 0);

create table finding_3 (
  inspection integer not null, comparison integer not null, number integer not null,
  view integer not null, same_as integer not null,
  kind text not null check (kind in ('added', 'removed')),
  box text not null, centroid text not null, position_m text, in_foot_m text, size_mm text,
  height_mm real, score real, p_value real, moved_from integer,
  primary key (inspection, comparison, number),
  foreign key (inspection, comparison) references comparison
) strict, without rowid;
insert into finding_3
  select f.inspection, c.number, f.number, view, same_as, kind, box, centroid, position_m, in_foot_m, size_mm,
         height_mm, score, p_value, moved_from
  from finding f join comparison c on c.inspection = f.inspection and c.compared_at = f.compared_at;
create table decision_3 (
  id integer primary key,
  inspection integer not null, comparison integer not null, finding integer not null,
  verdict text not null, note text not null, person text not null, decided_at text not null,
  foreign key (inspection, comparison, finding) references finding
) strict;
insert into decision_3
  select d.id, d.inspection, c.number, d.finding, verdict, note, person, decided_at
  from decision d join comparison c on c.inspection = d.inspection and c.compared_at = d.compared_at;
drop table decision;
drop table finding;
alter table finding_3 rename to finding;
alter table decision_3 rename to decision;
create index decision_of_finding on decision (inspection, comparison, finding);
alter table inspection drop column compared_at;

create table side_3 (
  inspection integer not null references inspection, side text not null check (side in ('initial', 'final')),
  round integer not null,
  taken_at text, -- null while it is under way
  person text not null, base text not null,
  primary key (inspection, side, round)
) strict, without rowid;
insert into side_3 select inspection, side, 1, taken_at, person, base from side;
drop table side;
alter table side_3 rename to side;

alter table account add column generation text not null default '';
update account set generation = lower(hex(randomblob(16)));
)sql";

/// Changes from version 3 to 4: findings of appearance, and the evidence for each finding.
inline constexpr const char* schema_4_from_3 = R"sql(
create table finding_4 (
  inspection integer not null, comparison integer not null, number integer not null,
  view integer not null, same_as integer not null,
  kind text not null check (kind in ('added', 'removed', 'appearance')),
  box text not null, centroid text not null, position_m text, in_foot_m text, size_mm text,
  height_mm real, score real, p_value real, moved_from integer,
  by_depth integer not null default 1, by_appearance integer not null default 0,
  primary key (inspection, comparison, number),
  foreign key (inspection, comparison) references comparison
) strict, without rowid;
insert into finding_4 (inspection, comparison, number, view, same_as, kind, box, centroid, position_m, in_foot_m,
                       size_mm, height_mm, score, p_value, moved_from)
  select inspection, comparison, number, view, same_as, kind, box, centroid, position_m, in_foot_m, size_mm,
         height_mm, score, p_value, moved_from
  from finding;
drop table finding;
alter table finding_4 rename to finding;
)sql";

/// Changes from version 4 to 5: coverage belongs to a comparison, so that earlier ones keep theirs; findings
/// that people mark; decisions and comparisons name the round of captures; inspections are closed.
inline constexpr const char* schema_5_from_4 = R"sql(
alter table comparison add column final_round integer not null default 0;
update comparison set final_round = coalesce((select max(s.round) from side s
  where s.inspection = comparison.inspection and s.side = 'final' and s.taken_at is not null), 0)
  where exists (select 1 from inspection i where i.id = comparison.inspection and i.comparison = comparison.number);
alter table decision add column round integer not null default 0;
update decision set round = coalesce((select c.final_round from comparison c
  where c.inspection = decision.inspection and c.number = decision.comparison), 0);
alter table finding add column above_surroundings_mm real;
alter table finding add column background_jump integer not null default 0;

create table compared_view_5 (
  inspection integer not null, comparison integer not null, view integer not null,
  method text not null, compared real not null, unseen real not null, invalid real not null, judged real not null,
  warnings text not null, left_out real, findable text,
  primary key (inspection, comparison, view),
  foreign key (inspection, comparison) references comparison
) strict, without rowid;
insert into compared_view_5 (inspection, comparison, view, method, compared, unseen, invalid, judged, warnings,
                             left_out)
  select v.inspection, i.comparison, v.view, v.method, v.compared, v.unseen, v.invalid, v.judged, v.warnings,
         v.left_out
  from compared_view v join inspection i on i.id = v.inspection where i.comparison > 0;
drop table compared_view;
alter table compared_view_5 rename to compared_view;

create table mark (
  inspection integer not null references inspection, number integer not null,
  view integer, comparison integer not null, round integer not null, picture text not null,
  box text not null, position_m text, in_foot_m text, size_mm text,
  note text not null, person text not null, marked_at text not null,
  primary key (inspection, number)
) strict, without rowid;
create table mark_decision (
  id integer primary key,
  inspection integer not null, mark integer not null, round integer not null,
  verdict text not null, note text not null, person text not null, decided_at text not null,
  foreign key (inspection, mark) references mark
) strict;
create index decision_of_mark on mark_decision (inspection, mark);
create table closing (
  inspection integer primary key references inspection,
  comparison integer not null, person text not null, note text not null, closed_at text not null
) strict;
)sql";

/// Changes from version 5 to 6: the greatest id that any inspection had, deleted ones included; what the
/// words of a search are compared with, stored, since a search that finds nothing reads it of all
/// inspections; how high the top of a finding is, and how clearly its view shows it; live pictures that were
/// kept.
inline constexpr const char* schema_6_from_5 = R"sql(
create table greatest_id (inspection integer not null) strict;
insert into greatest_id select coalesce(max(id), 0) from inspection;
create trigger inspection_has_id after insert on inspection begin
  update greatest_id set inspection = max(inspection, new.id);
end;

create table searched (inspection integer primary key, text text not null) strict;
insert into searched
  select id, aircraft || char(10) || zone || char(10) || work_order || char(10) || person || char(10) || id
  from inspection;
create trigger inspection_is_searched after insert on inspection begin
  insert into searched values (new.id, new.aircraft || char(10) || new.zone || char(10) || new.work_order
    || char(10) || new.person || char(10) || new.id);
end;
create trigger inspection_is_searched_no_more after delete on inspection begin
  delete from searched where inspection = old.id;
end;

alter table finding add column top_above_surroundings_mm real;
alter table finding add column top_is_least integer not null default 0;
alter table finding add column clear_px integer;

create table snapshot (
  inspection integer not null references inspection, number integer not null,
  picture text not null, note text not null, person text not null, taken_at text not null,
  primary key (inspection, number)
) strict, without rowid;
)sql";

/// Changes from version 6 to 7: plans of the work, and what comparisons found of them.
inline constexpr const char* schema_7_from_6 = R"sql(
create table plan (
  inspection integer not null references inspection, view integer not null, plan text not null,
  primary key (inspection, view)
) strict, without rowid;
alter table finding add column planned text not null default '';
alter table finding add column planned_item text not null default '';
alter table compared_view add column planned text not null default '[]';
)sql";

/// Changes from version 7 to 8: what a classifier calls findings, and what people call them.
inline constexpr const char* schema_8_from_7 = R"sql(
alter table finding add column likely_class text not null default '';
alter table finding add column class_probability real;
alter table decision add column object text not null default '';
alter table mark_decision add column object text not null default '';
)sql";

/// Changes from version 8 to 9: check-out lists.
inline constexpr const char* schema_9_from_8 = R"sql(
create table item (
  inspection integer not null references inspection, number integer not null,
  name text not null, identity text not null, quantity integer not null,
  person text not null, taken_at text not null,
  primary key (inspection, number)
) strict, without rowid;
create table item_statement (
  id integer primary key,
  inspection integer not null, item integer not null,
  returned integer not null, used integer not null, lost integer not null, released integer not null,
  note text not null, person text not null, stated_at text not null,
  foreign key (inspection, item) references item
) strict;
create index statement_on_item on item_statement (inspection, item);
)sql";

}  // namespace rva
