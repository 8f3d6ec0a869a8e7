namespace frostfill
{
int dummyForNow();
int dummyForNow() { return 0; }
}
